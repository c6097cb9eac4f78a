// SPDX-License-Identifier: BSD-3-Clause
#include "view/ScenePainter.h"

#include "base/DataSets.h"
#include "results/Colours.h"
#include "view/EdgeLines.h"
#include "view/LuminaireGlyphs.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCoordinate.h"
#include "vtkDataArray.h"
#include "vtkKalosSingularEdges.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"

namespace studio
{
namespace
{
vtkSmartPointer<vtkPolyData> linesOf(const QVector<QVector<Point>>& lines)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines)
  {
    cells->InsertNextCell(line.size());
    for (const auto& point : line)
      cells->InsertCellPoint(points->InsertNextPoint(point.GetData()));
  }
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

}  // namespace

ScenePainter::ScenePainter()
{
  this->Renderer->SetBackground(0.235, 0.245, 0.26);
  vtkNew<vtkCoordinate> side;
  side->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> line;
  line->SetInputData(linesOf({{{1, 0, 0}, {1, 1, 0}}}));
  line->SetTransformCoordinate(side);
  this->Divider->SetMapper(line);
  this->Divider->GetProperty()->SetColor(1, 1, 1);
  this->Divider->GetProperty()->SetLineWidth(2);
  this->Divider->VisibilityOff();
}

void ScenePainter::setPixelRatio(double ratio)
{
  if (ratio == this->PixelRatio)
    return;
  this->PixelRatio = ratio;
  if (this->Scene)
    this->setScene(this->Scene);
}

vtkSmartPointer<vtkActor> ScenePainter::addLines(vtkPolyData* lines, double width)
{
  const auto actor = lineActor(lines, width * this->PixelRatio);
  this->Renderer->AddActor(actor);
  return actor;
}

void ScenePainter::setScene(const ScenePtr& scene)
{
  this->Scene = scene;
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddActor2D(this->Divider);
  this->Receivers.setScene(scene);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(scene->surfaces());
  mapper->ScalarVisibilityOff();
  this->Shape = vtkSmartPointer<vtkActor>::New();
  this->Shape->SetMapper(mapper);
  this->Shape->GetProperty()->SetColor(0.62, 0.63, 0.65);
  this->Shape->GetProperty()->SetAmbient(0.6);
  this->Shape->GetProperty()->SetDiffuse(0.4);
  this->Shape->GetProperty()->BackfaceCullingOn();
  this->Renderer->AddActor(this->Shape);

  auto severity = [](vtkActor* actor) {
    vtkMapper* lines = actor->GetMapper();
    lines->SetScalarModeToUseCellFieldData();
    lines->SelectColorArray(vtkKalosSingularEdges::SeverityArrayName());
    lines->SetLookupTable(severityColours());
    lines->UseLookupTableScalarRangeOn();
  };
  const EdgeLines edges = edgeLines(scene->edges(), scene->size() / 120);
  this->Edges = this->addLines(edges.edges, 2);
  this->Contacts = this->addLines(edges.contacts, 3);
  severity(this->Edges);
  severity(this->Contacts);
  this->Luminaires = this->addLines(luminaireGlyphs(scene->luminaires(), 0.07 * scene->size()), 1);
  this->Luminaires->GetProperty()->SetColor(0.8, 0.69, 0.36);
  this->mark({});
}

void ScenePainter::paint(const Picture& picture, const Display& display)
{
  this->Receivers.clear();
  if (!this->Scene)
    return;
  bool surfaces = false;
  for (const NamedSet& set : dataSets(picture.data))
  {
    if (display.hidden.contains(set.name) || !arrayOf(set.data, picture.array.toUtf8().constData()))
      continue;
    const bool painted = set.name == SceneDocument::paintedName();
    surfaces = surfaces || painted;
    vtkSmartPointer<vtkDataSet> shape = set.data;
    if (painted)
      shape = this->onShape(set.data, picture);
    this->Receivers.add({set.name, shape}, picture, display.smooth, this->PixelRatio);
  }
  this->Shape->SetVisibility(!surfaces && !display.hidden.contains(SceneDocument::paintedName()));
  this->Edges->SetVisibility(display.edges);
  this->Contacts->SetVisibility(display.edges);
  this->Luminaires->SetVisibility(display.luminaires);
}

vtkSmartPointer<vtkDataSet> ScenePainter::onShape(vtkDataSet* receivers, const Picture& picture) const
{
  const PaintedSurface& painted = this->Scene->painted();
  if (!painted.standIns)
    return receivers;
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->CopyStructure(painted.shape);
  vtkDataArray* array = receivers->GetCellData()->GetArray(picture.array.toUtf8().constData());
  auto all = vtk::TakeSmartPointer(array->NewInstance());
  all->SetName(array->GetName());
  all->SetNumberOfComponents(array->GetNumberOfComponents());
  all->SetNumberOfTuples(shape->GetNumberOfCells());
  array->GetTuples(painted.standIns, all);
  shape->GetCellData()->AddArray(all);
  return shape;
}

void ScenePainter::mark(const QVector<QVector<Point>>& lines)
{
  if (this->Marks)
    this->Renderer->RemoveActor(this->Marks);
  this->Marks = this->addLines(linesOf(lines), 2.5);
  this->Marks->GetProperty()->SetColor(0.2, 1, 0.3);
}
}  // namespace studio
