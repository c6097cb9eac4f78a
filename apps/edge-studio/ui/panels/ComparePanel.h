// SPDX-License-Identifier: BSD-3-Clause
// Lists the results, and compares two of them.
#ifndef studio_ComparePanel_h
#define studio_ComparePanel_h

#include <QComboBox>
#include <QLabel>
#include <QListWidget>

#include "results/Comparison.h"
#include "session/Workbench.h"
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
    Difference
  };

  explicit ComparePanel(Workbench* bench, QWidget* parent = nullptr);

  Mode mode() const;
  ResultPtr other() const;  ///< what the shown result is compared with; null where there is nothing

  /// Of the shown result and the other one; computed once for each pair.
  const Comparison& comparison();

signals:
  void changed();

private:
  void list();
  void describe();

  Workbench* Bench;
  QListWidget* Results;
  QComboBox *ModeBox, *OtherBox;
  QLabel* About;
  ResultPtr First, Second;  // that Found is of
  Comparison Found;
};
}  // namespace studio

#endif
