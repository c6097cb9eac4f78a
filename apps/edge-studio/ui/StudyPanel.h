// SPDX-License-Identifier: BSD-3-Clause
// One method over trajectories, delta and epsilon: a picture, the error, the bias and the time of each.
#ifndef studio_StudyPanel_h
#define studio_StudyPanel_h

#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "SceneView.h"
#include "Workbench.h"

namespace studio
{
class StudyPanel : public QWidget
{
  Q_OBJECT

public:
  /// Pictures are taken from the view, as it looks while the study runs.
  StudyPanel(Workbench* bench, SceneView* view, QWidget* parent = nullptr);

private:
  void start();
  void takePicture();
  QString figures(const Result& result) const;

  Workbench* Bench;
  SceneView* View;
  QLineEdit *Trajectories, *Deltas, *Epsilons;
  QPushButton* Start;
  QTableWidget* Grid;
  int First = -1;  // index of the first result of the study; -1: none
  int Count = 0, Columns = 1;
};

/// "100, 1000, auto" as numbers, auto being 0; empty if anything else stands there or a number is not above 0.
QVector<double> numberList(const QString& text, bool allowAuto);
}  // namespace studio

#endif
