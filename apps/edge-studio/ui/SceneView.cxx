// SPDX-License-Identifier: BSD-3-Clause
#include "SceneView.h"

#include <QMouseEvent>
#include <cmath>

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindowInteractor.h"

namespace studio
{
SceneView::SceneView(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);  // four samples halve the frame rate of software OpenGL; still pictures get FXAA
  this->setRenderWindow(window);
  window->AddRenderer(this->First.renderer());
  window->AddRenderer(this->Second.renderer());
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->interactor()->SetInteractorStyle(style);
  this->setMinimumSize(240, 200);
  this->setMouseTracking(true);

  this->Soon.setSingleShot(true);
  connect(&this->Soon, &QTimer::timeout, this, [this] {
    if (this->isVisible())
      this->renderWindow()->Render();
  });
  style->AddObserver(vtkCommand::StartInteractionEvent, this, &SceneView::beginTurning);
  style->AddObserver(vtkCommand::EndInteractionEvent, this, &SceneView::endTurning);
  this->endTurning();
  window->AddObserver(vtkCommand::StartEvent, this, &SceneView::syncCameras);
  this->arrange();
}

void SceneView::setScene(const ScenePtr& scene)
{
  this->First.setScene(scene);
  this->Second.setScene(scene);
  if (scene->cameras().isEmpty())
    this->lookAlong({0.35, 0.8, -0.45}, {0, 0, 1});
  else
    this->look(scene->cameras().front());
}

void SceneView::paint(const Picture& left, const Picture& right, const Display& display)
{
  this->First.setPixelRatio(this->devicePixelRatioF());
  this->Second.setPixelRatio(this->devicePixelRatioF());
  this->First.paint(left, display);
  this->Second.paint(right, display);
  this->render();
  emit this->painted();
}

void SceneView::mark(const QVector<QVector<Point>>& lines)
{
  this->First.mark(lines);
  this->Second.mark(lines);
  this->render();
}

void SceneView::setLayoutMode(Layout layout)
{
  this->Mode = layout;
  this->arrange();
}

void SceneView::setSwipe(double position)
{
  this->SwipeAt = std::clamp(position, 0.02, 0.98);
  this->arrange();
}

// Both renderers are one picture cut at a line: each has a camera of its own, that sees its part of the whole.
void SceneView::arrange()
{
  const bool two = this->Mode != Layout::Single;
  const double cut = !two ? 1 : this->Mode == Layout::Swipe ? this->SwipeAt : 0.5;
  this->First.renderer()->SetViewport(0, 0, cut, 1);
  this->Second.renderer()->SetViewport(two ? cut : 0, 0, 1, 1);
  this->Second.renderer()->SetDraw(two);
  this->Second.renderer()->SetInteractive(false);
  // Where the middle of a part lies in the whole, in halves of the part's width.
  const bool whole = this->Mode == Layout::Swipe;
  this->First.renderer()->GetActiveCamera()->SetWindowCenter(whole ? (cut - 1) / cut : 0, 0);
  this->Second.renderer()->GetActiveCamera()->SetWindowCenter(whole ? cut / (1 - cut) : 0, 0);
  this->render();
}

void SceneView::beginTurning()
{
  this->First.renderer()->UseFXAAOff();
  this->Second.renderer()->UseFXAAOff();
}

void SceneView::endTurning()
{
  this->First.renderer()->UseFXAAOn();
  this->Second.renderer()->UseFXAAOn();
  this->render();
}

void SceneView::syncCameras()
{
  vtkCamera *from = this->First.renderer()->GetActiveCamera(), *to = this->Second.renderer()->GetActiveCamera();
  to->SetPosition(from->GetPosition());
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetViewUp(from->GetViewUp());
  to->SetViewAngle(from->GetViewAngle());
  to->SetClippingRange(from->GetClippingRange());
}

void SceneView::look(const CameraPreset& preset)
{
  vtkCamera* camera = this->First.renderer()->GetActiveCamera();
  camera->SetPosition(preset.position.data());
  camera->SetFocalPoint(preset.target.data());
  camera->SetViewUp(preset.up.data());
  camera->SetViewAngle(preset.fieldOfView);
  this->First.renderer()->ResetCameraClippingRange();
  this->render();
}

void SceneView::lookAlong(const Point& direction, const Point& up)
{
  vtkCamera* camera = this->First.renderer()->GetActiveCamera();
  camera->SetViewAngle(35);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-direction[0], -direction[1], -direction[2]);
  camera->SetViewUp(up.data());
  this->First.renderer()->ResetCamera();
  camera->Zoom(1.2);
  camera->SetViewAngle(camera->GetViewAngle());
  this->First.renderer()->ResetCameraClippingRange();
  this->render();
}

CameraPreset SceneView::camera() const
{
  vtkCamera* camera = const_cast<ScenePainter&>(this->First).renderer()->GetActiveCamera();
  CameraPreset preset;
  camera->GetPosition(preset.position.data());
  camera->GetFocalPoint(preset.target.data());
  camera->GetViewUp(preset.up.data());
  preset.fieldOfView = camera->GetViewAngle();
  return preset;
}

void SceneView::render()
{
  this->Soon.start();
}

QImage SceneView::picture()
{
  this->renderWindow()->Render();
  return this->grabFramebuffer();
}

bool SceneView::onSwipeLine(const QPointF& at) const
{
  return this->Mode == Layout::Swipe && std::abs(at.x() - this->SwipeAt * this->width()) < 6;
}

// VTK takes mouse events from here, before the handlers below: a drag of the swipe line is not for it.
bool SceneView::event(QEvent* event)
{
  const auto type = event->type();
  const bool press = type == QEvent::MouseButtonPress, release = type == QEvent::MouseButtonRelease;
  if (!press && !release && type != QEvent::MouseMove)
    return QVTKOpenGLNativeWidget::event(event);
  auto* mouse = static_cast<QMouseEvent*>(event);
  if (!this->Swiping && !(press && this->onSwipeLine(mouse->localPos())))
    return QVTKOpenGLNativeWidget::event(event);
  press ? this->mousePressEvent(mouse) : release ? this->mouseReleaseEvent(mouse) : this->mouseMoveEvent(mouse);
  return true;
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

void SceneView::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  this->First.setPixelRatio(this->devicePixelRatioF());
  this->Second.setPixelRatio(this->devicePixelRatioF());
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
