// SPDX-License-Identifier: BSD-3-Clause
// One method over trajectories, delta and epsilon: a picture, the error, the bias and the time of each, on one scale.
#ifndef studio_StudyPanel_h
#define studio_StudyPanel_h

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>

#include "charts/LegendBar.h"
#include "session/Workbench.h"
#include "view/SceneView.h"

namespace studio
{
class StudyPanel : public QWidget
{
  Q_OBJECT

public:
  /// The pictures use the viewpoint of the scene's view at the start of a study.
  StudyPanel(Workbench* bench, SceneView* view, QWidget* parent = nullptr);

private:
  void start();
  void showStudy();     // an empty grid for the study of the bench
  void refresh();       // what is new, or all where the scale or the display has changed
  void drawNext();      // one picture at a time: the window goes on meanwhile
  void writeFigures();  // below the pictures
  void lookFromHere();
  QTableWidgetItem* itemOf(int cell);

  Workbench* Bench;
  SceneView* View;
  QLineEdit *Trajectories, *Deltas, *Epsilons;
  QPushButton *Start, *Redraw;
  QTableWidget* Grid;
  LegendBar* Bar;
  QLabel* About;
  QTimer Soon;
  CameraPreset Camera;
  Display Drawn;  // that the pictures have
  std::array<double, 2> Range{0, 0};
  QVector<ResultPtr> Cells;  // complete results, row by row; null: not yet
  QVector<bool> Stale;       // their pictures are to be drawn
};

/// "100, 1000, auto" as numbers, auto being 0; empty if anything else stands there or a number is not above 0.
QVector<double> numberList(const QString& text, bool allowAuto);
}  // namespace studio

#endif
