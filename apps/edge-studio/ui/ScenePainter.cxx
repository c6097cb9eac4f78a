// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePainter.h"

#include "Colours.h"
#include "DataSets.h"
#include "EdgeLines.h"
#include "LuminaireGlyphs.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkContourFilter.h"
#include "vtkCoordinate.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkKalosSingularEdges.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVertexGlyphFilter.h"

namespace studio
{
namespace
{
vtkSmartPointer<vtkPolyData> linesOf(const QVector<QVector<std::array<double, 3>>>& lines)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines)
  {
    cells->InsertNextCell(line.size());
    for (const auto& point : line)
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
  }
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

/// Colours the mapper's own data by bands of luminance.
void photograph(vtkPolyDataMapper* mapper, const QByteArray& bandsName, bool byPoint, const Exposure& exposure)
{
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(mapper->GetInput());
  vtkDataSetAttributes* attributes = data->GetPointData();
  if (!byPoint)
    attributes = data->GetCellData();
  vtkDataArray* bands = attributes->GetArray(bandsName.constData());
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Photograph");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(bands->GetNumberOfTuples());
  for (vtkIdType i = 0; i < bands->GetNumberOfTuples(); ++i)
  {
    double rgb[3];
    bands->GetTuple(i, rgb);
    colours->SetTypedTuple(i, photographicColour(rgb, exposure).data());
  }
  attributes->AddArray(colours);
  mapper->SetInputData(data);
  mapper->SelectColorArray(colours->GetName());
  mapper->SetColorModeToDirectScalars();
  mapper->InterpolateScalarsBeforeMappingOff();
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
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -20);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(width * this->PixelRatio));
  actor->PickableOff();
  this->Renderer->AddActor(actor);
  return actor;
}

void ScenePainter::setScene(const ScenePtr& scene)
{
  this->Scene = scene;
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddActor2D(this->Divider);
  this->Receivers.clear();

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

void ScenePainter::clearReceivers()
{
  for (const auto& actor : this->Receivers)
    this->Renderer->RemoveActor(actor);
  this->Receivers.clear();
}

void ScenePainter::paint(const Picture& picture, const Display& display)
{
  this->clearReceivers();
  if (!this->Scene)
    return;
  bool surfaces = false;
  for (const NamedSet& set : dataSets(picture.data))
  {
    if (display.hidden.contains(set.name) || !arrayOf(set.data, picture.array.toUtf8().constData()))
      continue;
    const bool painted = set.name == SceneDocument::paintedName();
    surfaces = surfaces || painted;
    this->addReceivers(painted ? this->onShape(set.data, picture).Get() : set.data, picture, display.smooth);
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

void ScenePainter::addReceivers(vtkDataSet* data, const Picture& picture, bool smooth)
{
  const QByteArray name = picture.array.toUtf8();
  vtkNew<vtkPolyDataMapper> mapper;
  const bool ofPoints = data->GetPointData()->HasArray(name.constData());
  if (ofPoints)
  {
    vtkNew<vtkVertexGlyphFilter> vertices;
    vertices->SetInputData(data);
    vertices->Update();
    mapper->SetInputData(vertices->GetOutput());
  }
  else if (smooth || !picture.isolines.isEmpty())
  {
    vtkNew<vtkCellDataToPointData> interpolated;
    interpolated->SetInputData(data);
    interpolated->ProcessAllArraysOff();
    interpolated->AddCellDataArray(name.constData());
    interpolated->Update();
    if (!picture.isolines.isEmpty())
      this->addIsolines(vtkDataSet::SafeDownCast(interpolated->GetOutput()), picture);
    mapper->SetInputData(smooth ? vtkPolyData::SafeDownCast(interpolated->GetOutput())
                                : vtkPolyData::SafeDownCast(data));
    mapper->SetInterpolateScalarsBeforeMapping(smooth);
  }
  else
    mapper->SetInputData(vtkPolyData::SafeDownCast(data));
  const bool byPoint = ofPoints || smooth;
  byPoint ? mapper->SetScalarModeToUsePointFieldData() : mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(name.constData());
  if (picture.exposure)
    photograph(mapper, name, byPoint, *picture.exposure);
  else
  {
    mapper->SetLookupTable(picture.colours);
    mapper->UseLookupTableScalarRangeOn();
  }

  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(static_cast<float>(7 * this->PixelRatio));
  const bool plane = ofPoints || data->GetNumberOfCells() == 0 || data->GetCellType(0) != VTK_TRIANGLE;
  actor->GetProperty()->SetBackfaceCulling(!plane);
  if (plane)
  {
    // A calculation plane may lie on a surface: it is what one wants to see there.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -6);
  }
  if (plane && !ofPoints)
    this->addBorder(data);
  this->Renderer->AddActor(actor);
  this->Receivers << actor;
}

void ScenePainter::addIsolines(vtkDataSet* points, const Picture& picture)
{
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(points);
  contours->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                   picture.array.toUtf8().constData());
  for (int i = 0; i < picture.isolines.size(); ++i)
    contours->SetValue(i, picture.isolines[i]);
  contours->Update();
  const auto actor = this->addLines(contours->GetOutput(), 1.2);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(1, 1, 1);
  this->Receivers << actor;
}

// A plane hides what is below it: its border says that it is one.
void ScenePainter::addBorder(vtkDataSet* plane)
{
  vtkNew<vtkFeatureEdges> border;
  border->SetInputData(plane);
  border->FeatureEdgesOff();
  border->NonManifoldEdgesOff();
  border->ColoringOff();
  border->Update();
  const auto actor = this->addLines(border->GetOutput(), 1.2);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(0.75, 0.77, 0.8);
  this->Receivers << actor;
}

void ScenePainter::mark(const QVector<QVector<std::array<double, 3>>>& lines)
{
  if (this->Marks)
    this->Renderer->RemoveActor(this->Marks);
  this->Marks = this->addLines(linesOf(lines), 2.5);
  this->Marks->GetProperty()->SetColor(0.2, 1, 0.3);
}
}  // namespace studio
