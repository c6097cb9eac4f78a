// SPDX-License-Identifier: BSD-3-Clause
#include "charts/LegendBar.h"

#include <QPainter>
#include <cmath>

#include "results/Display.h"

namespace studio
{
namespace
{
QString number(double value)
{
  const double size = std::abs(value);
  // Round values need few digits; powers of ten are spelt out while they are short.
  return QString::number(value, 'g', size >= 1e3 && size < 1e6 ? 6 : 4);
}

class Drawing
{
public:
  Drawing(QPainter& painter, const QRectF& area, const Legend& legend, const QColor& ink, Qt::Orientation orientation)
      : Painter(painter),
        Area(area),
        Shown(legend),
        Ink(ink),
        Upright(orientation == Qt::Vertical),
        Line(QFontMetricsF(painter.font()).height())
  {
  }

  void all()
  {
    this->Painter.setPen(this->Ink);
    this->Upright ? this->placeUpright() : this->placeLying();
    this->bar();
    const double length = this->Upright ? this->Bar.height() : this->Bar.width();
    const int wanted = std::max(2, static_cast<int>(length / ((this->Upright ? 2.2 : 3.5) * this->Line)));
    const double* range = this->Shown.colours->GetTableRange();
    const bool lines = !this->Shown.isolines.isEmpty();
    for (double value : lines ? this->Shown.isolines : roundValues({range[0], range[1]}, this->logarithmic(), wanted))
      this->tick(value, lines);
  }

private:
  bool logarithmic() const { return this->Shown.colours->GetScale() == VTK_SCALE_LOG10; }

  void placeUpright()
  {
    const QRectF note(this->Area.left() + 8, this->Area.top(), this->Area.width() - 12,
                      this->Area.height() - 0.4 * this->Line);
    constexpr int below = Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap;
    this->Painter.drawText(note, below, this->Shown.note);
    this->Bar = QRectF(
        this->Area.left() + 10, this->Area.top() + 2.6 * this->Line, 16,
        this->Area.height() - 4.2 * this->Line - this->Painter.boundingRect(note, below, this->Shown.note).height());
    this->Painter.drawText(
        QRectF(this->Area.left() + 8, this->Area.top() + 0.3 * this->Line, this->Area.width() - 8, 2 * this->Line),
        Qt::AlignLeft | Qt::AlignTop, this->Shown.title + QLatin1Char('\n') + this->Shown.unit);
  }

  void placeLying()
  {
    this->Bar = this->Area.adjusted(1.6 * this->Line, 1.4 * this->Line, -1.6 * this->Line, 0);
    this->Bar.setHeight(12);
    this->Painter.drawText(
        QRectF(this->Bar.left(), this->Area.top(), this->Bar.width(), 1.3 * this->Line),
        Qt::AlignLeft | Qt::AlignVCenter,
        this->Shown.unit.isEmpty() ? this->Shown.title : this->Shown.title + QStringLiteral(", ") + this->Shown.unit);
  }

  void bar()
  {
    QLinearGradient gradient(this->Bar.bottomLeft(), this->Upright ? this->Bar.topLeft() : this->Bar.bottomRight());
    const int count = static_cast<int>(this->Shown.colours->GetNumberOfTableValues());
    for (int i = 0; i < count; i += 5)
    {
      const double* c = this->Shown.colours->GetTableValue(i);
      gradient.setColorAt(static_cast<double>(i) / (count - 1), QColor::fromRgbF(c[0], c[1], c[2]));
    }
    this->Painter.fillRect(this->Bar, gradient);
    this->Painter.setPen(QPen(this->Ink, 0.8));
    this->Painter.drawRect(this->Bar);
  }

  void tick(double value, bool isoline)
  {
    const double* range = this->Shown.colours->GetTableRange();
    const double t = this->logarithmic() ? std::log10(value / range[0]) / std::log10(range[1] / range[0])
                                         : (value - range[0]) / (range[1] - range[0]);
    if (!(t > -1e-3 && t < 1 + 1e-3))
      return;
    // From one long side of the bar to the other, and on to the number.
    const QPointF from = this->Upright ? QPointF(this->Bar.left(), this->Bar.bottom() - t * this->Bar.height())
                                       : QPointF(this->Bar.left() + t * this->Bar.width(), this->Bar.top());
    const QPointF to = this->Upright ? QPointF(this->Bar.right(), from.y()) : QPointF(from.x(), this->Bar.bottom());
    const QPointF one = this->Upright ? QPointF(1, 0) : QPointF(0, 1);
    if (isoline)
    {
      this->Painter.setPen(QPen(Qt::white, 1.2));
      this->Painter.drawLine(from + one, to - one);
      this->Painter.setPen(QPen(this->Ink, 0.8));
    }
    this->Painter.drawLine(to, to + 5 * one);
    if (this->Upright)
      this->Painter.drawText(QRectF(to.x() + 8, to.y() - this->Line / 2, this->Area.right() - to.x() - 8, this->Line),
                             Qt::AlignLeft | Qt::AlignVCenter, number(value));
    else
      this->Painter.drawText(QRectF(to.x() - 40, to.y() + 5, 80, this->Line), Qt::AlignHCenter | Qt::AlignTop,
                             number(value));
  }

  QPainter& Painter;
  QRectF Area, Bar;
  const Legend& Shown;
  QColor Ink;
  bool Upright;
  double Line;
};
}  // namespace

void drawLegend(QPainter& painter, const QRectF& area, const Legend& legend, const QColor& ink,
                Qt::Orientation orientation)
{
  if (!legend.colours)
    return;
  painter.save();
  Drawing(painter, area, legend, ink, orientation).all();
  painter.restore();
}

LegendBar::LegendBar(Qt::Orientation orientation, QWidget* parent) : QWidget(parent), Way(orientation)
{
  this->setSizePolicy(orientation == Qt::Vertical ? QSizePolicy::Fixed : QSizePolicy::Preferred,
                      orientation == Qt::Vertical ? QSizePolicy::Preferred : QSizePolicy::Fixed);
}

QSize LegendBar::sizeHint() const
{
  const int line = this->fontMetrics().height();
  return this->Way == Qt::Vertical ? QSize(6 * line, 300) : QSize(300, static_cast<int>(2.7 * line) + 19);
}

void LegendBar::setLegend(const Legend& legend)
{
  this->Shown = legend;
  this->update();
}

void LegendBar::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawLegend(painter, this->rect(), this->Shown, this->palette().color(QPalette::WindowText), this->Way);
}
}  // namespace studio
