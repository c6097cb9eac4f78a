// SPDX-License-Identifier: BSD-3-Clause
// Maps the values of a chart to positions in the drawing.
#ifndef studio_ChartAxes_h
#define studio_ChartAxes_h

#include <QPointF>
#include <QRectF>
#include <array>

#include "results/Chart.h"

namespace studio
{
struct Axis
{
  bool logarithmic = false;
  std::array<double, 2> range{0, 1};

  double fraction(double value) const;  ///< 0 at the lower end, 1 at the upper
  double value(double fraction) const;  ///< the other way round
  QVector<double> ticks(int count) const;
  QString label(double tick) const;
};

/// Ranges that hold all finite points of the series; a linear one is rounded outwards to its ticks.
Axis xAxis(const Chart& chart);
Axis yAxis(const Chart& chart);
}  // namespace studio

#endif
