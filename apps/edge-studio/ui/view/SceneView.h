// SPDX-License-Identifier: BSD-3-Clause
// The 3-D view: one picture, or two with one camera, side by side or with a swipe between them.
#ifndef studio_SceneView_h
#define studio_SceneView_h

#include <QVTKOpenGLNativeWidget.h>
#include <QLabel>
#include <QTimer>

#include "scene/Picking.h"
#include "view/ScenePainter.h"

namespace studio
{
class SceneView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  enum class Layout
  {
    Single,
    SideBySide,
    Swipe
  };

  explicit SceneView(QWidget* parent = nullptr);

  void setScene(const ScenePtr& scene);
  void paint(const Picture& left, const Picture& right, const Display& display);
  void mark(const QVector<QVector<Point>>& lines);
  /// Said at the top of each of two pictures.
  void setCaptions(const QString& left, const QString& right);
  void setPicking(std::shared_ptr<const Picking> picking) { this->Targets = std::move(picking); }

  void setLayoutMode(Layout layout);
  Layout layoutMode() const { return this->Mode; }
  void setSwipe(double position);  ///< [0, 1] from the left
  double swipe() const { return this->SwipeAt; }

  /// The field of view spans the smaller side of the view, or of each half.
  void look(const CameraPreset& camera);
  /// Fits the scene, seen along a direction.
  void lookAlong(const Point& direction, const Point& up);
  CameraPreset camera() const;

  void render();     ///< soon, once for all that changes until then
  QImage picture();  ///< rendered now
  /// Another picture of the scene, square, rendered now beside what is shown.
  QImage snapshot(const Picture& picture, const Display& display, const CameraPreset& camera);

signals:
  void picked(const studio::Pick& pick);
  void swiped(double position);

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void arrange();
  void placeCaptions();
  void beginTurning();
  void endTurning();
  void setCameras();
  bool onSwipeLine(const QPointF& at) const;
  void pickAt(const QPointF& at);

  ScenePtr Scene;
  ScenePainter First, Second, Aside;
  std::array<QLabel*, 2> Captions;
  std::array<QString, 2> CaptionTexts;
  double FieldOfView = 45;  // degrees, across the smaller side
  std::shared_ptr<const Picking> Targets;
  Layout Mode = Layout::Single;
  double SwipeAt = 0.5;
  QPointF PressedAt;
  bool Swiping = false;
  QTimer Soon;
};
}  // namespace studio

#endif
