// SPDX-License-Identifier: BSD-3-Clause
// Chooses the method and its effort, and shows the progress of the run.
#ifndef studio_MethodPanel_h
#define studio_MethodPanel_h

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

#include "session/Workbench.h"

class QFormLayout;

namespace studio
{
class MethodPanel : public QWidget
{
  Q_OBJECT

public:
  explicit MethodPanel(Workbench* bench, QWidget* parent = nullptr);

private:
  QFormLayout* makeForm();
  void readSettings();   // from the bench into the widgets
  void writeSettings();  // the other way
  void showRun();
  void togglePause();

  Workbench* Bench;
  QComboBox *MethodBox, *GoalBox;
  QDoubleSpinBox *Amount, *Delta, *Epsilon;
  QSpinBox* Seed;
  QPushButton *RunButton, *PauseButton, *CancelButton;
  QProgressBar* Progress;
  QLabel *Times, *Errors;
  QTimer Tick;
};
}  // namespace studio

#endif
