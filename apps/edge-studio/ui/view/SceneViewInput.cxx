// SPDX-License-Identifier: BSD-3-Clause
// Mouse and keyboard in the view: turning the scene, dragging the swipe line, picking a point.
#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>

#include "view/SceneView.h"
#include "vtkCamera.h"

namespace studio
{
bool SceneView::onSwipeLine(const QPointF& at) const
{
  return this->Mode == Layout::Swipe && std::abs(at.x() - this->SwipeAt * this->width()) < 6;
}

// VTK takes mouse events and keys from here, before the handlers below: a drag of the swipe line is not for it.
bool SceneView::event(QEvent* event)
{
  const auto type = event->type();
  if (type == QEvent::KeyPress || type == QEvent::KeyRelease)
    return QWidget::event(event);  // VTK's keys would switch to wireframe, stereo, and so on
  const bool press = type == QEvent::MouseButtonPress, release = type == QEvent::MouseButtonRelease;
  if (!press && !release && type != QEvent::MouseMove)
    return QVTKOpenGLNativeWidget::event(event);
  auto* mouse = static_cast<QMouseEvent*>(event);
  if (!this->Swiping && !(press && this->onSwipeLine(mouse->localPos())))
    return QVTKOpenGLNativeWidget::event(event);
  press ? this->mousePressEvent(mouse) : release ? this->mouseReleaseEvent(mouse) : this->mouseMoveEvent(mouse);
  return true;
}

void SceneView::keyPressEvent(QKeyEvent* event)
{
  constexpr double turn = 5, step = 1.1;
  vtkCamera* camera = this->First.renderer()->GetActiveCamera();
  switch (event->key())
  {
    case Qt::Key_Left:
      camera->Azimuth(turn);
      break;
    case Qt::Key_Right:
      camera->Azimuth(-turn);
      break;
    case Qt::Key_Up:
    case Qt::Key_Down:
      camera->Elevation(event->key() == Qt::Key_Up ? -turn : turn);
      camera->OrthogonalizeViewUp();
      break;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      camera->Dolly(event->key() == Qt::Key_Plus ? step : 1 / step);
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  this->First.renderer()->ResetCameraClippingRange();
  this->render();
}

void SceneView::mousePressEvent(QMouseEvent* event)
{
  this->PressedAt = event->localPos();
  this->Swiping = event->button() == Qt::LeftButton && this->onSwipeLine(event->localPos());
  if (!this->Swiping)
    QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void SceneView::mouseMoveEvent(QMouseEvent* event)
{
  this->setCursor(this->Swiping || this->onSwipeLine(event->localPos()) ? Qt::SplitHCursor : Qt::ArrowCursor);
  if (!this->Swiping)
    return QVTKOpenGLNativeWidget::mouseMoveEvent(event);
  this->setSwipe(event->localPos().x() / this->width());
  emit this->swiped(this->SwipeAt);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event)
{
  if (!this->Swiping)
    QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  const bool click = (event->localPos() - this->PressedAt).manhattanLength() < 4;
  if (!this->Swiping && click && event->button() == Qt::LeftButton)
    this->pickAt(event->localPos());
  this->Swiping = false;
}

void SceneView::pickAt(const QPointF& at)
{
  if (!this->Targets)
    return;
  const double ratio = this->devicePixelRatioF(), x = at.x() * ratio, y = (this->height() - 1 - at.y()) * ratio;
  vtkRenderer* renderer = this->First.renderer();
  if (this->Mode != Layout::Single && at.x() > renderer->GetViewport()[2] * this->width())
    renderer = this->Second.renderer();
  auto toWorld = [&](double depth) {
    renderer->SetDisplayPoint(x, y, depth);
    renderer->DisplayToWorld();
    const double* world = renderer->GetWorldPoint();
    return Point{world[0] / world[3], world[1] / world[3], world[2] / world[3]};
  };
  if (const auto pick = this->Targets->first(toWorld(0), toWorld(1)))
    emit this->picked(*pick);
}
}  // namespace studio
