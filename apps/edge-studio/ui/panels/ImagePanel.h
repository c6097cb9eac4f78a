// SPDX-License-Identifier: BSD-3-Clause
// Computes the luminance from the current view, shows it, reads out pixels, and saves it.
#ifndef studio_ImagePanel_h
#define studio_ImagePanel_h

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "session/Workbench.h"
#include "view/Pictures.h"
#include "view/SceneView.h"

namespace studio
{
/// Shows an image as large as fits, and tells which pixel the pointer is over.
class ImageView : public QWidget
{
  Q_OBJECT

public:
  explicit ImageView(QWidget* parent = nullptr);
  void setImage(const QImage& image);
  void setHint(const QString& text);  ///< said where there is no image
  const QImage& image() const { return this->Shown; }

signals:
  void pointed(const QPoint& pixel);  ///< from the top left

protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  QRectF place() const;

  QImage Shown;
  QString Hint;
};

class ImagePanel : public QWidget
{
  Q_OBJECT

public:
  /// The camera and the shape of the image are those of the view.
  ImagePanel(Workbench* bench, SceneView* view, QWidget* parent = nullptr);

  QImage picture() const { return this->View->image(); }
  Legend legend() const;

signals:
  void changed();
  void saveAsked();

private:
  void makeControls();
  void compute();
  void clear();
  void show();
  void develop();
  void tell(const QPoint& pixel);

  Workbench* Bench;
  SceneView* Scene;
  ResultPtr Developed;
  int Height = 0;  // of the image asked for last; 0: none
  ImageView* View;
  QComboBox* Rows;
  QPushButton *Compute, *Cancel, *Save;
  QProgressBar* Progress;
  QLabel *About, *Pixel;
};
}  // namespace studio

#endif
