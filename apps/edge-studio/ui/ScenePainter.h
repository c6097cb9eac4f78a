// SPDX-License-Identifier: BSD-3-Clause
// What one renderer shows of a scene: painted receivers, isolines, luminaires, singular edges.
#ifndef studio_ScenePainter_h
#define studio_ScenePainter_h

#include <QVector>
#include <optional>

#include "Display.h"
#include "SceneDocument.h"
#include "ToneMapping.h"
#include "vtkActor2D.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

class vtkActor;

namespace studio
{
/// One array of a data object in colours.
struct Picture
{
  vtkSmartPointer<vtkDataObject> data;
  QString array;
  vtkSmartPointer<vtkLookupTable> colours;
  QVector<double> isolines;
  std::optional<Exposure> exposure;  ///< the array has linear red, green and blue, to be shown as a photograph
};

class ScenePainter
{
public:
  ScenePainter();

  vtkRenderer* renderer() const { return this->Renderer; }

  const ScenePtr& scene() const { return this->Scene; }

  /// Pixels of the screen per pixel of the design: lines keep their looks at any scaling.
  void setPixelRatio(double ratio);
  void setScene(const ScenePtr& scene);
  /// Sets that the picture does not colour are drawn as plain grey shapes, others not at all.
  void paint(const Picture& picture, const Display& display);
  /// A small cross on the surface, and a line from there.
  void mark(const QVector<QVector<std::array<double, 3>>>& lines);

  /// A line at the right side, towards another picture.
  void setDivider(bool shown) { this->Divider->SetVisibility(shown); }

private:
  void clearReceivers();
  void addReceivers(vtkDataSet* data, const Picture& picture, bool smooth);
  vtkSmartPointer<vtkDataSet> onShape(vtkDataSet* receivers, const Picture& picture) const;
  void addIsolines(vtkDataSet* points, const Picture& picture);
  void addBorder(vtkDataSet* plane);
  vtkSmartPointer<vtkActor> addLines(vtkPolyData* lines, double width);

  ScenePtr Scene;
  double PixelRatio = 1;
  vtkNew<vtkRenderer> Renderer;
  QVector<vtkSmartPointer<vtkActor>> Receivers;
  vtkNew<vtkActor2D> Divider;
  vtkSmartPointer<vtkActor> Shape, Edges, Contacts, Luminaires, Marks;
};
}  // namespace studio

#endif
