// SPDX-License-Identifier: BSD-3-Clause
#include "LegendBar.h"

#include <QPainter>
#include <cmath>

#include "Display.h"

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
}  // namespace

void drawLegend(QPainter& painter, const QRectF& area, const Legend& legend, const QColor& ink)
{
  if (!legend.colours)
    return;
  painter.save();
  painter.setPen(ink);
  const double line = QFontMetricsF(painter.font()).height();
  const QRectF noteArea(area.left() + 8, area.top(), area.width() - 12, area.height() - 0.4 * line);
  const double below =
      painter.boundingRect(noteArea, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, legend.note).height();
  const QRectF bar(area.left() + 10, area.top() + 2.6 * line, 16, area.height() - 4.2 * line - below);
  painter.drawText(QRectF(area.left() + 8, area.top() + 0.3 * line, area.width() - 8, 2 * line),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, legend.title + QLatin1Char('\n') + legend.unit);

  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  const int count = static_cast<int>(legend.colours->GetNumberOfTableValues());
  for (int i = 0; i < count; i += 5)
  {
    const double* c = legend.colours->GetTableValue(i);
    gradient.setColorAt(static_cast<double>(i) / (count - 1), QColor::fromRgbF(c[0], c[1], c[2]));
  }
  painter.fillRect(bar, gradient);
  painter.setPen(QPen(ink, 0.8));
  painter.drawRect(bar);

  const double* range = legend.colours->GetTableRange();
  const bool logarithmic = legend.colours->GetScale() == VTK_SCALE_LOG10;
  auto place = [&](double value) {
    const double t = logarithmic ? std::log10(value / range[0]) / std::log10(range[1] / range[0])
                                 : (value - range[0]) / (range[1] - range[0]);
    return bar.bottom() - t * bar.height();
  };
  const int wanted = std::max(2, static_cast<int>(bar.height() / (2.2 * line)));
  const bool lines = !legend.isolines.isEmpty();
  for (double value : lines ? legend.isolines : roundValues({range[0], range[1]}, logarithmic, wanted))
  {
    const double y = place(value);
    if (!(y >= bar.top() - 1 && y <= bar.bottom() + 1))
      continue;
    if (lines)
    {
      painter.setPen(QPen(Qt::white, 1.2));
      painter.drawLine(QPointF(bar.left() + 1, y), QPointF(bar.right() - 1, y));
      painter.setPen(QPen(ink, 0.8));
    }
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 5, y));
    painter.drawText(QRectF(bar.right() + 8, y - line / 2, area.right() - bar.right() - 8, line),
                     Qt::AlignLeft | Qt::AlignVCenter, number(value));
  }
  painter.drawText(noteArea, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, legend.note);
  painter.restore();
}

LegendBar::LegendBar(QWidget* parent) : QWidget(parent)
{
  this->setMinimumWidth(92);
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
  drawLegend(painter, this->rect(), this->Shown, this->palette().color(QPalette::WindowText));
}
}  // namespace studio
