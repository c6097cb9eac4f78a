// SPDX-License-Identifier: BSD-3-Clause
// Lists the results, and compares two of them.
#ifndef studio_ComparePanel_h
#define studio_ComparePanel_h

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "results/Comparison.h"
#include "session/Workbench.h"
#include "view/Pictures.h"
#include "view/SceneView.h"

namespace studio
{
class ComparePanel : public QWidget
{
  Q_OBJECT

public:
  enum class Mode
  {
    Off,
    SideBySide,
    Swipe,
    DifferenceInErrors,
    DifferenceInLux,
    DifferenceInPercent
  };

  explicit ComparePanel(Workbench* bench, QWidget* parent = nullptr);

  Mode mode() const;
  bool showsDifference() const { return this->mode() >= Mode::DifferenceInErrors; }
  ResultPtr other() const;  ///< what the shown result is compared with; null where there is nothing

  /// The shown result less the other one, where showsDifference().
  ShownPictures differencePicture();

signals:
  void changed();

private:
  void makeResults();
  void list();
  void describe();
  void rename();
  void enable();
  const Comparison& comparison();  // computed once for each pair

  Workbench* Bench;
  QListWidget* Results;
  QPushButton *Rename, *Delete;
  QComboBox *ModeBox, *OtherBox;
  QLabel* About;
  ResultPtr First, Second;  // that Found is of
  Comparison Found;
};
}  // namespace studio

#endif
