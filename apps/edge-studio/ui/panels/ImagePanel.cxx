// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ImagePanel.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

#include "common/Wording.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkKalosArrayNames.h"
#include "vtkPointData.h"

namespace studio
{
ImageView::ImageView(QWidget* parent) : QWidget(parent)
{
  this->setMinimumSize(240, 200);
  this->setMouseTracking(true);
}

void ImageView::setImage(const QImage& image)
{
  this->Shown = image;
  this->update();
}

void ImageView::setHint(const QString& text)
{
  this->Hint = text;
  this->update();
}

QRectF ImageView::place() const
{
  const QSizeF size = QSizeF(this->Shown.size()).scaled(this->size(), Qt::KeepAspectRatio);
  return {QPointF((this->width() - size.width()) / 2, (this->height() - size.height()) / 2), size};
}

void ImageView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), QColor(0x3c, 0x3e, 0x42));
  if (!this->Shown.isNull())
    return painter.drawImage(this->place(), this->Shown);
  painter.setPen(QColor(0xc8, 0xca, 0xce));
  const int margin = this->width() / 6;
  painter.drawText(this->rect().adjusted(margin, 0, -margin, 0), Qt::AlignCenter | Qt::TextWordWrap, this->Hint);
}

void ImageView::mouseMoveEvent(QMouseEvent* event)
{
  const QRectF place = this->place();
  if (!this->Shown.isNull() && place.contains(event->localPos()))
    emit this->pointed(
        {static_cast<int>((event->localPos().x() - place.left()) / place.width() * this->Shown.width()),
         static_cast<int>((event->localPos().y() - place.top()) / place.height() * this->Shown.height())});
}

void ImagePanel::makeControls()
{
  this->View = new ImageView;
  this->View->setObjectName(QStringLiteral("imageView"));
  this->View->setHint(
      tr("Turn the scene to what you want to see, then compute the luminance from there, gloss and mirrors included."));
  this->Rows = new QComboBox;
  this->Rows->setObjectName(QStringLiteral("imageRows"));
  for (int rows : {128, 256, 512, 1024})
    this->Rows->addItem(tr("%1 rows").arg(rows), rows);
  this->Rows->setCurrentIndex(1);
  this->Rows->setToolTip(tr("Height of the image in pixels"));
  auto button = [](const QString& text, const QString& name, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    return made;
  };
  this->Compute = button(tr("Compute from this view"), QStringLiteral("computeImage"),
                         tr("Computes the luminance that the camera of the scene sees"));
  this->Cancel = button(tr("Cancel"), QStringLiteral("cancelImage"), tr("Stops the image and keeps what it has"));
  this->Save =
      button(tr("Save as EXR…"), QStringLiteral("saveImage"), tr("Saves the luminance in cd/m², not the colours"));
  this->Progress = new QProgressBar;
  this->Progress->setRange(0, 1000);
  this->Progress->setTextVisible(false);
  this->Progress->setFixedHeight(6);
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("imageAbout"));
  this->Pixel = new QLabel;
  this->Pixel->setObjectName(QStringLiteral("imagePixel"));
  this->Pixel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

ImagePanel::ImagePanel(Workbench* bench, SceneView* view, QWidget* parent) : QWidget(parent), Bench(bench), Scene(view)
{
  this->makeControls();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Rows);
  buttons->addWidget(this->Compute);
  buttons->addWidget(this->Cancel);
  buttons->addStretch(1);
  buttons->addWidget(this->Save);
  auto* words = new QHBoxLayout;
  words->addWidget(this->About, 1);
  words->addWidget(this->Pixel);
  auto* below = new QVBoxLayout;
  below->setContentsMargins(10, 6, 10, 8);
  below->addLayout(buttons);
  below->addWidget(this->Progress);
  below->addLayout(words);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(this->View, 1);
  layout->addLayout(below);

  connect(this->Compute, &QPushButton::clicked, this, &ImagePanel::compute);
  connect(this->Cancel, &QPushButton::clicked, &bench->image(), &CameraImage::cancel);
  connect(this->Save, &QPushButton::clicked, this, &ImagePanel::saveAsked);
  connect(this->View, &ImageView::pointed, this, &ImagePanel::tell);
  connect(&bench->image(), &CameraImage::changed, this, &ImagePanel::show);
  connect(&bench->image(), &CameraImage::problem, bench, &Workbench::problem);
  connect(bench, &Workbench::sceneChanged, this, &ImagePanel::clear);
  connect(bench, &Workbench::displayChanged, this, &ImagePanel::develop);
  this->show();
}

void ImagePanel::compute()
{
  const int rows = this->Rows->currentData().toInt();
  const double shape = static_cast<double>(this->Scene->width()) / std::max(1, this->Scene->height());
  this->Bench->image().start(
      this->Bench->scene(),
      {this->Scene->camera(), std::max(1, static_cast<int>(std::lround(rows * shape))), rows, this->Bench->settings()});
}

void ImagePanel::clear()
{
  this->Developed.reset();
  this->View->setImage({});
  this->Pixel->clear();
  this->show();
}

void ImagePanel::show()
{
  const CameraImage& image = this->Bench->image();
  this->Compute->setEnabled(this->Bench->scene() && !image.active());
  this->Cancel->setEnabled(image.active());
  if (const int height = image.request() ? image.request()->height : 0; height != this->Height)
  {
    this->Height = height;
    this->Rows->setCurrentIndex(std::max(this->Rows->findData(height), height > 0 ? -1 : 1));
  }
  const ResultPtr result = image.result();
  this->Save->setEnabled(result && !result->preview);
  const Run* run = image.run();
  this->Progress->setValue(run ? static_cast<int>(1000 * run->progress()) : result ? 1000 : 0);
  QStringList about;
  if (run)
    about << describeTimes(*run);
  else if (result)
    about << tr("%1 · of the session").arg(duration(result->seconds));
  if (result && !result->preview)
    about << tr("standard error %1").arg(percent(result->quality.typical));
  this->About->setText(about.join(QStringLiteral(" · ")));
  if (result && result != this->Developed)
    this->develop();
}

void ImagePanel::develop()
{
  this->Developed = this->Bench->image().result();
  if (!this->Developed)
    return;
  this->View->setImage(developed(this->Developed, forImages(this->Bench->display())));
  emit this->changed();
}

Legend ImagePanel::legend() const
{
  return this->Developed ? legendOf(this->Developed, forImages(this->Bench->display())) : Legend();
}

void ImagePanel::tell(const QPoint& pixel)
{
  vtkImageData* image = this->Bench->image().data();
  const int width = image->GetDimensions()[0], height = image->GetDimensions()[1];
  const vtkIdType index = static_cast<vtkIdType>(height - 1 - pixel.y()) * width + pixel.x();
  if (pixel.x() >= width || pixel.y() >= height)
    return;
  auto value = [&](const char* name) { return image->GetPointData()->GetArray(name)->GetComponent(index, 0); };
  this->Pixel->setText(tr("%1 ± %2 cd/m²")
                           .arg(value(vtkKalosArrayNames::Luminance), 0, 'g', 4)
                           .arg(value(vtkKalosArrayNames::LuminanceStandardError), 0, 'g', 2));
}
}  // namespace studio
