// SPDX-License-Identifier: BSD-3-Clause
// Error against time of every result, while they run.
#ifndef studio_SpeedPanel_h
#define studio_SpeedPanel_h

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "charts/ChartView.h"
#include "session/Workbench.h"

namespace studio
{
class SpeedPanel : public QWidget
{
  Q_OBJECT

public:
  explicit SpeedPanel(Workbench* bench, QWidget* parent = nullptr);
  Chart chart() const;

private:
  void runAll();
  void show();
  void showRatios();

  Workbench* Bench;
  ChartView* View;
  QComboBox* Base;
  QLabel* Ratios;
};
}  // namespace studio

#endif
