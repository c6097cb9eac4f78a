// SPDX-License-Identifier: BSD-3-Clause
// Draws a chart: on the screen, into an image, into SVG, with the same strokes. By hand: of the libraries that were
// tried, vtkChartXY fills bands wrongly on a logarithmic axis and takes a second for its first picture, and Qt Charts cuts
// the names of a legend off, wants a power of ten at the end of an axis, and has no mark for what is off the scale.
#ifndef studio_ChartDrawing_h
#define studio_ChartDrawing_h

#include <QRectF>

#include "results/Chart.h"

class QPainter;

namespace studio
{
void drawChart(QPainter& painter, const QRectF& area, const Chart& chart);
}  // namespace studio

#endif
