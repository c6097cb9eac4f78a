// SPDX-License-Identifier: BSD-3-Clause
// Shows a chart, and saves it. A click on a name takes its curve away and back, the wheel zooms along x about the
// pointer, a double click shows all again, and the values under the pointer are read out.
#ifndef studio_ChartView_h
#define studio_ChartView_h

#include <QSet>
#include <QWidget>
#include <optional>

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
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  void hideSeries();

  Chart Shown;
  QSet<QString> Hidden;
  std::optional<QPointF> Pointer;  // over the plot
};
}  // namespace studio

#endif
