// SPDX-License-Identifier: BSD-3-Clause
// Draws a chart: on the screen, into an image, into SVG, with the same strokes.
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
