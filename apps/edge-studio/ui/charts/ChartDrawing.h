// SPDX-License-Identifier: BSD-3-Clause
// Draws a chart: on the screen, into an image, into SVG, with the same strokes. By hand: of the libraries that were
// tried, vtkChartXY fills bands wrongly on a logarithmic axis and takes a second for its first picture, and Qt Charts
// cuts the names of a legend off, wants a power of ten at the end of an axis, and has no mark for what is off the
// scale.
#ifndef studio_ChartDrawing_h
#define studio_ChartDrawing_h

#include <QFont>
#include <QRectF>

#include "charts/ChartAxes.h"

class QPainter;

namespace studio
{
/// Where the parts of a chart lie.
struct ChartLayout
{
  QRectF area, plot;
  Axis x, y;
  double line = 0;  ///< height of a line of text
  struct Name
  {
    int series;
    QRectF place;
  };
  QVector<Name> names;  ///< of the legend, each once

  QPointF at(const QPointF& value) const;  ///< not above the plot
};

QFont chartFont(QFont base);
ChartLayout layOut(const QFont& font, const QRectF& area, const Chart& chart);
void drawChart(QPainter& painter, const QRectF& area, const Chart& chart);

/// A line at the value of x under the pointer, and the nearest points of each series in words.
void drawReadOut(QPainter& painter, const ChartLayout& layout, const Chart& chart, const QPointF& pointer);
}  // namespace studio

#endif
