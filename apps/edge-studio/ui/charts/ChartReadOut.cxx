// SPDX-License-Identifier: BSD-3-Clause
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "charts/ChartDrawing.h"

namespace studio
{
namespace
{
const QPointF* nearest(const Series& series, const ChartLayout& layout, double x)
{
  const QPointF* found = nullptr;
  for (const QPointF& point : series.points)
    if (!found || std::abs(layout.at(point).x() - x) < std::abs(layout.at(*found).x() - x))
      found = &point;
  return found;
}
}  // namespace

void drawReadOut(QPainter& painter, const ChartLayout& layout, const Chart& chart, const QPointF& pointer)
{
  struct Row
  {
    QString text;
    QColor colour;
  };
  QVector<Row> rows{
      {chart.xLabel.section(QLatin1Char(','), 0, 0) + QLatin1Char(' ') +
           QString::number(layout.x.value((pointer.x() - layout.plot.left()) / layout.plot.width()), 'g', 3),
       QColor(0x30, 0x33, 0x38)}};
  for (const Series& series : chart.series)
    if (const QPointF* point = series.hidden ? nullptr : nearest(series, layout, pointer.x()))
      rows.append({QStringLiteral("%1  %2").arg(series.name).arg(point->y(), 0, 'g', 4), QColor(QRgb(series.colour))});
  painter.save();
  painter.setFont(chartFont(painter.font()));
  painter.setPen(QPen(QColor(0x80, 0x83, 0x88), 1, Qt::DotLine));
  painter.drawLine(QPointF(pointer.x(), layout.plot.top()), QPointF(pointer.x(), layout.plot.bottom()));
  double width = 0;
  for (const Row& row : rows)
    width = std::max(width, painter.fontMetrics().horizontalAdvance(row.text) + layout.line);
  const bool right = pointer.x() + width + 8 < layout.plot.right();
  const QRectF box(right ? pointer.x() + 8 : pointer.x() - 8 - width, layout.plot.top() + 4, width,
                   (static_cast<double>(rows.size()) + 0.5) * layout.line);
  painter.fillRect(box, QColor(255, 255, 255, 225));
  painter.setPen(QColor(0xc8, 0xca, 0xce));
  painter.drawRect(box);
  for (int i = 0; i < rows.size(); ++i)
  {
    painter.setPen(rows[i].colour);
    painter.drawText(QPointF(box.left() + 0.5 * layout.line, box.top() + (i + 1) * layout.line), rows[i].text);
  }
  painter.restore();
}
}  // namespace studio
