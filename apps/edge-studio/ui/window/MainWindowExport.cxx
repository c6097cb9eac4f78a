// SPDX-License-Identifier: BSD-3-Clause
// Exports pictures, images and values.
#include <QFileDialog>
#include <QPainter>

#include "common/SaveDialog.h"
#include "panels/ImagePanel.h"
#include "results/Export.h"
#include "window/MainWindow.h"

namespace studio
{
void MainWindow::exportPictureAs()
{
  const QString path = askSavePath(this, tr("Export the picture"), {{tr("PNG"), QStringLiteral("png")}});
  if (!path.isEmpty() && !this->pictureWithLegend().save(path, "PNG"))
    this->complain(tr("%1: file: cannot be written; expected a place that can be written").arg(path));
}

void MainWindow::exportResultsTo()
{
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Export the values, CSV and VTP, into a folder"));
  if (!folder.isEmpty() && mayReplace(this, exportedFiles(*this->Bench.shown(), folder)))
    this->attempt([&] { exportResult(*this->Bench.shown(), folder); });
}

void MainWindow::exportImageAs()
{
  const QString path = askSavePath(this, tr("Export the image"), {{tr("OpenEXR"), QStringLiteral("exr")}});
  if (!path.isEmpty())
    this->attempt([&] { exportImage(*this->Bench.image().result(), path); });
}

QImage MainWindow::pictureWithLegend()
{
  const QImage view = this->showsImage() ? this->Image->picture() : this->View->picture();
  if (!this->Bar->legend().colours)
    return view;
  const double ratio = view.devicePixelRatio();
  QImage image(view.width() + static_cast<int>(this->Bar->width() * ratio), view.height(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(QPointF(0, 0), view);
  drawLegend(painter, QRectF(view.width() / ratio, 0, this->Bar->width(), view.height() / ratio), this->Bar->legend(),
             Qt::black);
  return image;
}
}  // namespace studio
