// SPDX-License-Identifier: BSD-3-Clause
#include "charts/ChartView.h"

#include <QBuffer>
#include <QContextMenuEvent>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QSvgGenerator>

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
  this->setToolTip(tr("Right click: save as SVG, PNG or CSV"));
}

void ChartView::setChart(const Chart& chart)
{
  this->Shown = chart;
  this->update();
}

void ChartView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  drawChart(painter, this->rect(), this->Shown);
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
