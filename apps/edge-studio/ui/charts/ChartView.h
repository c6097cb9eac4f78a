// SPDX-License-Identifier: BSD-3-Clause
// Shows a chart, and saves it.
#ifndef studio_ChartView_h
#define studio_ChartView_h

#include <QWidget>

#include "results/Chart.h"

namespace studio
{
class ChartView : public QWidget
{
  Q_OBJECT

public:
  explicit ChartView(QWidget* parent = nullptr);
  void setChart(const Chart& chart);
  const Chart& chart() const { return this->Shown; }

  /// To .svg, .png or .csv, as the name says. Throws Problem where the file cannot be written.
  static void save(const Chart& chart, const QString& path, const QSizeF& size = {720, 480});

protected:
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  Chart Shown;
};
}  // namespace studio

#endif
