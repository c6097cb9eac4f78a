// SPDX-License-Identifier: BSD-3-Clause
#include "charts/ChartAxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/Display.h"

namespace studio
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

Axis axisOver(double low, double high, bool logarithmic)
{
  if (!(low <= high))
    return {logarithmic, {logarithmic ? 1.0 : 0.0, logarithmic ? 10.0 : 1.0}};
  if (low == high)
  {
    low = logarithmic ? low / 2 : low - std::max(1.0, 0.05 * std::abs(low));
    high = logarithmic ? high * 2 : high + std::max(1.0, 0.05 * std::abs(high));
  }
  return {logarithmic, {low, high}};
}

bool usable(double value, bool logarithmic)
{
  return std::isfinite(value) && (!logarithmic || value > 0);
}
}  // namespace

double Axis::fraction(double value) const
{
  if (this->logarithmic)
    return std::log(std::max(value, 1e-300) / this->range[0]) / std::log(this->range[1] / this->range[0]);
  return (value - this->range[0]) / (this->range[1] - this->range[0]);
}

double Axis::value(double fraction) const
{
  if (this->logarithmic)
    return this->range[0] * std::pow(this->range[1] / this->range[0], fraction);
  return this->range[0] + fraction * (this->range[1] - this->range[0]);
}

QVector<double> Axis::ticks(int count) const
{
  return roundValues(this->range, this->logarithmic, count);
}

QString Axis::label(double tick) const
{
  const double size = std::abs(tick);
  if (size != 0 && (size >= 1e6 || size < 1e-4))
    return QStringLiteral("%1").arg(tick, 0, 'e', 0).replace(QStringLiteral("e+0"), QStringLiteral("e"));
  return QString::number(tick, 'g', 6);
}

Axis xAxis(const Chart& chart)
{
  if (chart.xRange)
    return {chart.logX, *chart.xRange};
  double low = infinity, high = -infinity;
  for (const Series& series : chart.series)
    for (const QPointF& point : series.points)
      if (!series.hidden && usable(point.x(), chart.logX))
      {
        low = std::min(low, point.x());
        high = std::max(high, point.x());
      }
  return axisOver(low, high, chart.logX);
}

Axis yAxis(const Chart& chart)
{
  double low = infinity, high = -infinity;
  for (const Series& series : chart.series)
    for (int i = 0; i < series.points.size(); ++i)
    {
      const double y = series.points[i].y(), half = i < series.halfWidth.size() ? series.halfWidth[i] : 0;
      for (double end : {y - half, y + half})
        if (!series.hidden && usable(end, chart.logY))
        {
          low = std::min(low, end);
          high = std::max(high, end);
        }
    }
  if (chart.logY)
    return axisOver(low * 0.8, high * 1.25, true);
  if (chart.yLimit > 0)
    high = std::min(high, chart.yLimit);
  if (chart.yFromZero)
    low = std::min(0.0, std::max(low, 0.0));
  Axis axis = axisOver(low, high, false);
  const QVector<double> ticks = axis.ticks(6);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 0;
  if (step > 0)
    axis.range = {std::floor(axis.range[0] / step + 1e-9) * step, std::ceil(axis.range[1] / step - 1e-9) * step};
  return axis;
}
}  // namespace studio
