// SPDX-License-Identifier: BSD-3-Clause
#include "charts/ChartView.h"

#include <QBuffer>
#include <QContextMenuEvent>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QSvgGenerator>
#include <cmath>

#include "base/Files.h"
#include "charts/ChartDrawing.h"
#include "common/SaveDialog.h"

namespace studio
{
namespace
{
void saveAs(QWidget* parent, const Chart& chart)
{
  const QString path = askSavePath(parent, ChartView::tr("Save the chart"),
                                   {{ChartView::tr("SVG"), QStringLiteral("svg")},
                                    {ChartView::tr("PNG"), QStringLiteral("png")},
                                    {ChartView::tr("CSV"), QStringLiteral("csv")}});
  if (path.isEmpty())
    return;
  try
  {
    ChartView::save(chart, path);
  }
  catch (const Problem& problem)
  {
    QMessageBox::warning(parent, ChartView::tr("Edge Studio"), problem.message());
  }
}
}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent)
{
  this->setMinimumSize(260, 150);
  this->setMouseTracking(true);
  this->setToolTip(tr("Click a name to hide its curve. Wheel: zoom. Double click: all. Right click: save."));
}

void ChartView::setChart(const Chart& chart)
{
  const auto range = this->Shown.xRange;
  this->Shown = chart;
  this->Shown.xRange = chart.xLabel == this->Shown.xLabel ? range : std::nullopt;
  this->hideSeries();
}

void ChartView::hideSeries()
{
  for (Series& series : this->Shown.series)
    series.hidden = this->Hidden.contains(series.name);
  this->update();
}

void ChartView::mousePressEvent(QMouseEvent* event)
{
  const ChartLayout layout = layOut(chartFont(this->font()), this->rect(), this->Shown);
  for (const ChartLayout::Name& name : layout.names)
    if (event->button() == Qt::LeftButton && name.place.contains(event->localPos()))
    {
      const QString& clicked = this->Shown.series[name.series].name;
      if (!this->Hidden.remove(clicked))
        this->Hidden.insert(clicked);
      return this->hideSeries();
    }
}

void ChartView::mouseMoveEvent(QMouseEvent* event)
{
  const QRectF plot = layOut(chartFont(this->font()), this->rect(), this->Shown).plot;
  this->Pointer.reset();
  if (plot.contains(event->localPos()))
    this->Pointer = event->localPos();
  this->update();
}

void ChartView::leaveEvent(QEvent*)
{
  this->Pointer.reset();
  this->update();
}

void ChartView::mouseDoubleClickEvent(QMouseEvent*)
{
  this->Shown.xRange.reset();
  this->update();
}

void ChartView::wheelEvent(QWheelEvent* event)
{
  const ChartLayout layout = layOut(chartFont(this->font()), this->rect(), this->Shown);
  const double at = (event->position().x() - layout.plot.left()) / layout.plot.width(),
               scale = std::pow(0.8, event->angleDelta().y() / 120.0);
  if (at < 0 || at > 1)
    return;
  this->Shown.xRange = {{layout.x.value(at - scale * at), layout.x.value(at + scale * (1 - at))}};
  this->update();
}

void ChartView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  drawChart(painter, this->rect(), this->Shown);
  if (this->Pointer && !this->Shown.series.isEmpty())
    drawReadOut(painter, layOut(chartFont(this->font()), this->rect(), this->Shown), this->Shown, *this->Pointer);
}

void ChartView::contextMenuEvent(QContextMenuEvent* event)
{
  QMenu menu;
  connect(menu.addAction(tr("Save the chart…")), &QAction::triggered, this, [this] { saveAs(this, this->Shown); });
  menu.exec(event->globalPos());
}

void ChartView::save(const Chart& chart, const QString& path, const QSizeF& size)
{
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const QRectF area(QPointF(0, 0), size);
  if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
    buffer.write(toCsv(chart));
  else if (path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive))
  {
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setSize(size.toSize());
    svg.setViewBox(area);
    svg.setTitle(chart.title.isEmpty() ? chart.yLabel : chart.title);
    QPainter painter(&svg);
    drawChart(painter, area, chart);
  }
  else
  {
    QImage image((2 * size).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(2);
    QPainter painter(&image);
    drawChart(painter, area, chart);
    painter.end();
    image.save(&buffer, "PNG");
  }
  writeFile(path, bytes);
}
}  // namespace studio
