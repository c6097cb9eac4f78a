// SPDX-License-Identifier: BSD-3-Clause
// Receivers in the colours of a picture, with isolines, and the borders of calculation planes.
#ifndef studio_ReceiverActors_h
#define studio_ReceiverActors_h

#include <QHash>

#include "base/DataSets.h"
#include "scene/SceneDocument.h"
#include "view/Picture.h"
#include "vtkRenderer.h"

class vtkActor;

namespace studio
{
/// Lines in front of the surfaces that they lie on, in their own colours.
vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines, double width);

class ReceiverActors
{
public:
  explicit ReceiverActors(vtkRenderer* renderer) : Renderer(renderer) {}

  void setScene(const ScenePtr& scene);
  void clear();
  /// A set of receivers: points, planes, or triangles of surfaces.
  void add(const NamedSet& set, const Picture& picture, bool smooth, double pixelRatio);

private:
  vtkPolyData* borderOf(const NamedSet& set);
  /// With the array at its points, in finer cells where there are some.
  vtkSmartPointer<vtkPolyData> interpolated(const NamedSet& set, const QByteArray& array) const;
  void addActor(vtkProp* actor);
  void addLines(vtkPolyData* lines, const Point& colour, const Point& lift, double pixelRatio);
  void addIsolines(vtkDataSet* points, const Picture& picture, const Point& lift, double pixelRatio);

  vtkRenderer* Renderer;
  ScenePtr Scene;
  QHash<QString, vtkSmartPointer<vtkPolyData>> Borders;
  QVector<vtkSmartPointer<vtkProp>> Actors;
};
}  // namespace studio

#endif
