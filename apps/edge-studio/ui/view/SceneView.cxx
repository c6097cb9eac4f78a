// SPDX-License-Identifier: BSD-3-Clause
#include "view/SceneView.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindowInteractor.h"

namespace studio
{
namespace
{
void place(vtkRenderer* renderer, const CameraPreset& preset)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(preset.position.GetData());
  camera->SetFocalPoint(preset.target.GetData());
  camera->SetViewUp(preset.up.GetData());
  renderer->ResetCameraClippingRange();
}
}  // namespace

SceneView::SceneView(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);  // four samples halve the frame rate of software OpenGL; still pictures get FXAA
  this->setRenderWindow(window);
  window->AddRenderer(this->First.renderer());
  window->AddRenderer(this->Second.renderer());
  window->AddRenderer(this->Aside.renderer());
  this->Aside.renderer()->DrawOff();
  this->Aside.renderer()->SetInteractive(false);
  this->Aside.renderer()->UseFXAAOn();
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->interactor()->SetInteractorStyle(style);
  this->setMinimumSize(240, 200);
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);

  for (QLabel*& caption : this->Captions)
  {
    caption = new QLabel(this);
    caption->setStyleSheet(QStringLiteral("color: white; background: rgb(30, 32, 34); padding: 2px 6px"));
    caption->setAttribute(Qt::WA_TransparentForMouseEvents);
    caption->hide();
  }
  this->Soon.setSingleShot(true);
  connect(&this->Soon, &QTimer::timeout, this, [this] {
    if (this->isVisible())
      this->renderWindow()->Render();
  });
  style->AddObserver(vtkCommand::StartInteractionEvent, this, &SceneView::beginTurning);
  style->AddObserver(vtkCommand::EndInteractionEvent, this, &SceneView::endTurning);
  this->endTurning();
  window->AddObserver(vtkCommand::StartEvent, this, &SceneView::setCameras);
  this->arrange();
}

void SceneView::setScene(const ScenePtr& scene)
{
  this->Scene = scene;
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
}

void SceneView::mark(const QVector<QVector<Point>>& lines)
{
  this->First.mark(lines);
  this->Second.mark(lines);
  this->render();
}

void SceneView::setCaptions(const QString& left, const QString& right)
{
  this->CaptionTexts = {left, right};
  this->placeCaptions();
}

void SceneView::placeCaptions()
{
  const double cut = this->First.renderer()->GetViewport()[2];
  const std::array<double, 2> middle{0.5 * cut, 0.5 * (1 + cut)}, share{cut, 1 - cut};
  for (int i = 0; i < 2; ++i)
  {
    QLabel* caption = this->Captions[i];
    const int room = static_cast<int>(share[i] * this->width()) - 24;
    caption->setText(caption->fontMetrics().elidedText(this->CaptionTexts[i], Qt::ElideRight, std::max(1, room)));
    caption->adjustSize();
    caption->move(static_cast<int>(middle[i] * this->width()) - caption->width() / 2, 6);
    caption->setVisible(!caption->text().isEmpty());
  }
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

// The two renderers show one picture divided by a line; the camera of each sees its own part.
void SceneView::arrange()
{
  const bool two = this->Mode != Layout::Single;
  const double cut = !two ? 1 : this->Mode == Layout::Swipe ? this->SwipeAt : 0.5;
  this->First.renderer()->SetViewport(0, 0, cut, 1);
  this->Second.renderer()->SetViewport(two ? cut : 0, 0, 1, 1);
  this->Second.renderer()->SetDraw(two);
  this->Second.renderer()->SetInteractive(false);
  this->First.setDivider(two);
  // Where the middle of a part lies in the whole, in halves of the part's width.
  const bool whole = this->Mode == Layout::Swipe;
  this->First.renderer()->GetActiveCamera()->SetWindowCenter(whole ? (cut - 1) / cut : 0, 0);
  this->Second.renderer()->GetActiveCamera()->SetWindowCenter(whole ? cut / (1 - cut) : 0, 0);
  this->placeCaptions();
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

void SceneView::setCameras()
{
  vtkCamera *from = this->First.renderer()->GetActiveCamera(), *to = this->Second.renderer()->GetActiveCamera();
  const double width = this->Mode == Layout::SideBySide ? 0.5 * this->width() : this->width();
  from->SetViewAngle(this->camera().verticalAngle(width / std::max(1, this->height())));
  to->SetPosition(from->GetPosition());
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetViewUp(from->GetViewUp());
  to->SetViewAngle(from->GetViewAngle());
  to->SetClippingRange(from->GetClippingRange());
}

void SceneView::look(const CameraPreset& preset)
{
  this->FieldOfView = preset.fieldOfView;
  place(this->First.renderer(), preset);
  this->render();
}

void SceneView::lookAlong(const Point& direction, const Point& up)
{
  this->look(fitted(this->Scene->surfaces()->GetBounds(), direction, up,
                    static_cast<double>(this->width()) / std::max(1, this->height())));
}

CameraPreset SceneView::camera() const
{
  vtkCamera* camera = const_cast<ScenePainter&>(this->First).renderer()->GetActiveCamera();
  CameraPreset preset;
  camera->GetPosition(preset.position.GetData());
  camera->GetFocalPoint(preset.target.GetData());
  camera->GetViewUp(preset.up.GetData());
  preset.fieldOfView = this->FieldOfView;
  return preset;
}

void SceneView::render()
{
  this->Soon.start();
}

QImage SceneView::picture()
{
  this->renderWindow()->Render();
  QImage picture = this->grabFramebuffer();
  for (QLabel* caption : this->Captions)
    if (!caption->text().isEmpty())
      caption->render(&picture, caption->pos(), {}, DrawWindowBackground);
  return picture;
}

QImage SceneView::snapshot(const Picture& picture, const Display& display, const CameraPreset& camera)
{
  this->Aside.setPixelRatio(this->devicePixelRatioF());
  if (this->Aside.scene() != this->Scene)
    this->Aside.setScene(this->Scene);
  this->Aside.paint(picture, display);
  place(this->Aside.renderer(), camera);
  const double shape = static_cast<double>(this->width()) / std::max(1, this->height());
  this->Aside.renderer()->GetActiveCamera()->SetViewAngle(camera.verticalAngle(shape));
  this->First.renderer()->DrawOff();
  this->Second.renderer()->DrawOff();
  this->Aside.renderer()->DrawOn();
  this->renderWindow()->Render();
  const QImage whole = this->grabFramebuffer();
  this->Aside.renderer()->DrawOff();
  this->Aside.paint({}, display);
  this->First.renderer()->DrawOn();
  this->arrange();
  this->renderWindow()->Render();  // at once, so that the screen never shows the other picture
  const int side = std::min(whole.width(), whole.height());
  return whole.copy((whole.width() - side) / 2, (whole.height() - side) / 2, side, side);
}

void SceneView::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  this->First.setPixelRatio(this->devicePixelRatioF());
  this->Second.setPixelRatio(this->devicePixelRatioF());
  this->placeCaptions();
}
}  // namespace studio
