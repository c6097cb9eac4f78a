// SPDX-License-Identifier: BSD-3-Clause
#include "charts/ChartDrawing.h"

#include <QPainter>
#include <QSet>
#include <algorithm>
#include <cmath>

#include "charts/ChartAxes.h"

namespace studio
{
namespace
{
const QColor ink(0x30, 0x33, 0x38), faint(0xe3, 0xe4, 0xe7), pale(0xa0, 0xa3, 0xa8);

class Drawing
{
public:
  Drawing(QPainter& painter, const QRectF& area, const Chart& chart)
      : Painter(painter), Shown(chart), Place(layOut(painter.font(), area, chart)), Plot(Place.plot), Line(Place.line)
  {
  }

  void all()
  {
    this->axes();
    this->Painter.save();
    this->Painter.setClipRect(this->Plot.adjusted(-4, -4, 4, 4));
    for (const Series& series : this->Shown.series)
      if (!series.hidden)
        this->band(series);
    for (const Series& series : this->Shown.series)
      if (!series.hidden)
        this->series(series);
    this->Painter.restore();
    this->legend();
  }

private:
  QPointF at(const QPointF& value) const { return this->Place.at(value); }

  void axes()
  {
    QFont bold = this->Painter.font();
    bold.setBold(true);
    this->Painter.setPen(ink);
    if (!this->Shown.title.isEmpty())
    {
      const QFont usual = this->Painter.font();
      this->Painter.setFont(bold);
      this->Painter.drawText(
          QRectF(this->Plot.left(), this->Place.area.top() + 0.3 * this->Line, this->Plot.width(), 1.3 * this->Line),
          Qt::AlignLeft | Qt::AlignVCenter, this->Shown.title);
      this->Painter.setFont(usual);
    }
    const int across = std::max(2, static_cast<int>(this->Plot.width() / (5 * this->Line)));
    for (double tick : this->Place.x.ticks(across))
    {
      const double x = this->at({tick, this->Place.y.range[0]}).x();
      this->Painter.setPen(QPen(faint, 1));
      this->Painter.drawLine(QPointF(x, this->Plot.top()), QPointF(x, this->Plot.bottom()));
      this->Painter.setPen(ink);
      this->Painter.drawText(QRectF(x - 40, this->Plot.bottom() + 3, 80, this->Line), Qt::AlignHCenter,
                             this->Place.x.label(tick));
    }
    for (double tick :
         this->Place.y.ticks(std::clamp(static_cast<int>(this->Plot.height() / (2.2 * this->Line)), 2, 8)))
    {
      const double y = this->at({this->Place.x.range[0], tick}).y();
      this->Painter.setPen(QPen(faint, 1));
      this->Painter.drawLine(QPointF(this->Plot.left(), y), QPointF(this->Plot.right(), y));
      this->Painter.setPen(ink);
      this->Painter.drawText(QRectF(this->Place.area.left(), y - this->Line / 2,
                                    this->Plot.left() - this->Place.area.left() - 5, this->Line),
                             Qt::AlignRight | Qt::AlignVCenter, this->Place.y.label(tick));
    }
    this->Painter.setPen(QPen(ink, 1));
    this->Painter.drawLine(this->Plot.bottomLeft(), this->Plot.bottomRight());
    this->Painter.drawLine(this->Plot.bottomLeft(), this->Plot.topLeft());
    this->Painter.drawText(
        QRectF(this->Plot.left(), this->Plot.bottom() + 1.35 * this->Line, this->Plot.width(), this->Line),
        Qt::AlignRight, this->Shown.xLabel);
    this->Painter.save();
    this->Painter.translate(this->Place.area.left() + 0.2 * this->Line, this->Plot.top());
    this->Painter.rotate(-90);
    this->Painter.drawText(QRectF(-this->Plot.height(), 0, this->Plot.height(), this->Line), Qt::AlignRight,
                           this->Shown.yLabel);
    this->Painter.restore();
  }

  void band(const Series& series)
  {
    if (series.halfWidth.size() != series.points.size() || series.points.size() < 2)
      return;
    QPolygonF outline;
    for (int i = 0; i < series.points.size(); ++i)
      outline << this->at(series.points[i] + QPointF(0, series.halfWidth[i]));
    for (int i = static_cast<int>(series.points.size()) - 1; i >= 0; --i)
    {
      QPointF low = series.points[i] - QPointF(0, series.halfWidth[i]);
      low.setY(std::max(low.y(), this->Place.y.range[0]));
      outline << this->at(low);
    }
    QColor colour(QRgb(series.colour));
    colour.setAlphaF(0.16);
    this->Painter.setPen(Qt::NoPen);
    this->Painter.setBrush(colour);
    this->Painter.drawPolygon(outline);
  }

  void series(const Series& series)
  {
    const QColor colour(QRgb(series.colour));
    this->Painter.setPen(QPen(colour, series.dashed ? 1.3 : 1.8, series.dashed ? Qt::DashLine : Qt::SolidLine,
                              Qt::FlatCap, Qt::RoundJoin));
    this->Painter.setBrush(Qt::NoBrush);
    if (series.style == Series::Style::Bars)
    {
      this->Painter.setPen(QPen(Qt::white, 0.8));
      this->Painter.setBrush(colour);
      for (int i = 0; i + 1 < series.points.size(); ++i)
        this->Painter.drawRect(
            QRectF(this->at({series.points[i].x(), 0}), this->at({series.points[i + 1].x(), series.points[i].y()}))
                .normalized());
      return;
    }
    QPolygonF line;
    for (const QPointF& point : series.points)
      line << this->at(point);
    if (series.style != Series::Style::Points)
      this->Painter.drawPolyline(line);
    this->Painter.setBrush(colour);
    this->Painter.setPen(Qt::NoPen);
    for (int i = 0; i < line.size(); ++i)
    {
      if (this->Place.y.fraction(series.points[i].y()) > 1)
      {
        const QPointF arrow[] = {line[i] + QPointF(-4, 4), line[i] + QPointF(4, 4), line[i] + QPointF(0, -3)};
        this->Painter.drawPolygon(arrow, 3);
      }
      else if (series.style != Series::Style::Line)
        this->Painter.drawEllipse(line[i], 2.6, 2.6);
    }
  }

  void legend()
  {
    for (const ChartLayout::Name& name : this->Place.names)
    {
      const Series& series = this->Shown.series[name.series];
      const double middle = name.place.center().y(), left = name.place.left();
      const QColor colour(QRgb(series.colour));
      this->Painter.setPen(QPen(series.hidden ? faint : colour, series.style == Series::Style::Bars ? 8 : 2.4,
                                series.dashed ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
      this->Painter.drawLine(QPointF(left, middle), QPointF(left + 1.2 * this->Line, middle));
      this->Painter.setPen(series.hidden ? pale : ink);
      this->Painter.drawText(QPointF(left + 1.5 * this->Line, middle + 0.33 * this->Line), series.name);
    }
  }

  QPainter& Painter;
  const Chart& Shown;
  ChartLayout Place;
  QRectF Plot;
  double Line;
};
}  // namespace

QPointF ChartLayout::at(const QPointF& value) const
{
  const double up = std::min(1.0, this->y.fraction(value.y()));
  return {this->plot.left() + this->x.fraction(value.x()) * this->plot.width(),
          this->plot.bottom() - up * this->plot.height()};
}

QFont chartFont(QFont base)
{
  base.setPixelSize(12);
  return base;
}

ChartLayout layOut(const QFont& font, const QRectF& area, const Chart& chart)
{
  const QFontMetricsF metrics(font);
  const double line = metrics.height(), top = chart.title.isEmpty() ? 0.6 * line : 1.9 * line,
               left = area.left() + 3.9 * line, width = area.width() - 5 * line;
  ChartLayout layout{area, {}, xAxis(chart), yAxis(chart), line, {}};
  // Names in rows above the plot.
  double x = 0, y = 0;
  QSet<QString> named;
  for (int i = 0; i < chart.series.size(); ++i)
  {
    const QString& name = chart.series[i].name;
    if (named.contains(name))
      continue;
    named.insert(name);
    const double wanted = metrics.horizontalAdvance(name) + 2.4 * line;
    if (x > 0 && x + wanted > width)
    {
      x = 0;
      y += 1.15 * line;
    }
    layout.names.append({i, QRectF(left + x, area.top() + top + 0.1 * line + y, wanted - 0.9 * line, line)});
    x += wanted;
  }
  const double legend = (named.isEmpty() ? 0 : y + 1.15 * line) + 0.4 * line;
  layout.plot = area.adjusted(3.9 * line, top + legend, -1.1 * line, -2.9 * line);
  return layout;
}

void drawChart(QPainter& painter, const QRectF& area, const Chart& chart)
{
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, Qt::white);
  painter.setFont(chartFont(painter.font()));
  const bool blank =
      std::all_of(chart.series.begin(), chart.series.end(), [](const Series& s) { return s.points.isEmpty(); });
  if (!blank)
    Drawing(painter, area, chart).all();
  else
  {
    painter.setPen(QColor(0x80, 0x83, 0x88));
    painter.drawText(area.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, chart.empty);
  }
  painter.restore();
}
}  // namespace studio
