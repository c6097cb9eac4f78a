// SPDX-License-Identifier: BSD-3-Clause
// The content of one renderer: painted receivers, isolines, luminaires, singular edges.
#ifndef studio_ScenePainter_h
#define studio_ScenePainter_h

#include <QVector>

#include "results/Display.h"
#include "scene/SceneDocument.h"
#include "view/Picture.h"
#include "view/ReceiverActors.h"
#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

class vtkActor;

namespace studio
{
class ScenePainter
{
public:
  ScenePainter();

  vtkRenderer* renderer() const { return this->Renderer; }

  const ScenePtr& scene() const { return this->Scene; }

  /// Physical pixels per logical pixel; line widths are scaled by it.
  void setPixelRatio(double ratio);
  void setScene(const ScenePtr& scene);
  /// Sets that the picture does not colour are drawn as plain grey shapes, others not at all.
  void paint(const Picture& picture, const Display& display);
  /// A small cross on the surface, and a line from there.
  void mark(const QVector<QVector<Point>>& lines);

  /// A line at the right side, towards another picture.
  void setDivider(bool shown) { this->Divider->SetVisibility(shown); }

private:
  vtkSmartPointer<vtkDataSet> onShape(vtkDataSet* receivers, const Picture& picture) const;
  vtkSmartPointer<vtkActor> addLines(vtkPolyData* lines, double width);

  ScenePtr Scene;
  double PixelRatio = 1;
  vtkNew<vtkRenderer> Renderer;
  ReceiverActors Receivers{this->Renderer};
  vtkNew<vtkActor2D> Divider;
  vtkSmartPointer<vtkActor> Shape, Edges, Contacts, Luminaires, Marks;
};
}  // namespace studio

#endif
