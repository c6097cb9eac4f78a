// SPDX-License-Identifier: BSD-3-Clause
// The data of a chart, for the widgets that draw it and for SVG, PNG and CSV.
#ifndef studio_Chart_h
#define studio_Chart_h

#include <QPointF>
#include <QString>
#include <QVector>
#include <array>
#include <optional>

namespace studio
{
struct Series
{
  enum class Style
  {
    Line,
    Points,
    LineAndPoints,
    Bars  ///< from y = 0 to the point, as wide as the distance to the next
  };

  QString name;
  unsigned colour = 0;  ///< 0xRRGGBB
  QVector<QPointF> points;
  QVector<double> halfWidth;  ///< of the band in y; empty: none
  Style style = Style::Line;
  bool dashed = false;
  bool hidden = false;  ///< only its name is drawn
};

struct Chart
{
  QString title, xLabel, yLabel;
  bool logX = false, logY = false;
  bool yFromZero = true;  ///< on a linear axis
  double yLimit = 0;      ///< what lies above is drawn at the upper edge, as an arrow; 0: none does
  std::optional<std::array<double, 2>> xRange;  ///< that is shown; all points where it is not given
  QVector<Series> series;
  QString empty;  ///< said where there is nothing to draw
};

/// A straight line in the chart.
Series straight(const QString& name, unsigned colour, bool dashed, const QPointF& from, const QPointF& to);

/// `series,x,y,half_width` with a line of names of the axes above as a comment; numbers are locale-independent.
QByteArray toCsv(const Chart& chart);

/// The colour of a method in every chart.
unsigned methodColour(int method);
}  // namespace studio

#endif
