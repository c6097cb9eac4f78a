// SPDX-License-Identifier: BSD-3-Clause
#include "view/ReceiverActors.h"

#include "view/ValueLabels.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVertexGlyphFilter.h"

namespace studio
{
namespace
{
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

bool hasPoints(const NamedSet& set, const QByteArray& array)
{
  return set.data->GetPointData()->HasArray(array.constData());
}

bool isPlane(const NamedSet& set)
{
  return set.data->GetNumberOfCells() > 0 && set.data->GetCellType(0) != VTK_TRIANGLE &&
         set.data->GetCellData()->GetNormals();
}
}  // namespace

vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines, double width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -20);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->PickableOff();
  return actor;
}

void ReceiverActors::setScene(const ScenePtr& scene)
{
  this->clear();
  this->Scene = scene;
  this->Borders.clear();
}

void ReceiverActors::clear()
{
  for (const auto& actor : this->Actors)
    this->Renderer->RemoveViewProp(actor);
  this->Actors.clear();
}

void ReceiverActors::addActor(vtkProp* actor)
{
  this->Renderer->AddViewProp(actor);
  this->Actors << actor;
}

vtkPolyData* ReceiverActors::borderOf(const NamedSet& set)
{
  vtkSmartPointer<vtkPolyData>& lines = this->Borders[set.name];
  if (!lines)
  {
    vtkNew<vtkFeatureEdges> border;
    border->SetInputData(set.data);
    border->FeatureEdgesOff();
    border->NonManifoldEdgesOff();
    border->ColoringOff();
    border->Update();
    lines = border->GetOutput();
  }
  return lines;
}

vtkSmartPointer<vtkPolyData> ReceiverActors::interpolated(const NamedSet& set, const QByteArray& array) const
{
  auto* data = vtkPolyData::SafeDownCast(set.data);
  if (const auto fine = this->Scene->fineShadows(set.name))
    if (auto picture = fine->picture(data, array.constData()))
      return picture;
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(data);
  toPoints->ProcessAllArraysOff();
  toPoints->AddCellDataArray(array.constData());
  toPoints->Update();
  return toPoints->GetPolyDataOutput();
}

void ReceiverActors::add(const NamedSet& set, const Picture& picture, bool smooth, double pixelRatio)
{
  const QByteArray name = picture.array.toUtf8();
  const bool ofPoints = hasPoints(set, name), plane = !ofPoints && isPlane(set);
  vtkNew<vtkPolyData> data;
  // A plane may lie on a surface, and is what one wants to see there: a little in front of it. An offset of its depth
  // would cost more than all the rest of a picture, where software draws it.
  Point lift(0, 0, 0);
  if (plane)
    lift = 3e-4 * this->Scene->size() * Point(set.data->GetCellData()->GetNormals()->GetTuple3(0));
  if (ofPoints)
  {
    vtkNew<vtkVertexGlyphFilter> vertices;
    vertices->SetInputData(set.data);
    vertices->Update();
    data->ShallowCopy(vertices->GetOutput());
  }
  else
  {
    data->ShallowCopy(set.data);
    if (smooth || !picture.isolines.isEmpty())
    {
      const auto points = this->interpolated(set, name);
      if (!picture.isolines.isEmpty())
        this->addIsolines(points, picture, lift, pixelRatio);
      if (smooth)
        data->ShallowCopy(points);
    }
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetInterpolateScalarsBeforeMapping(!ofPoints && smooth);
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
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(lift[0], lift[1], lift[2]);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(static_cast<float>(7 * pixelRatio));
  actor->GetProperty()->SetBackfaceCulling(!ofPoints && !plane);
  this->addActor(actor);
  if (plane && picture.values)
    for (const auto& label : cellLabels(set.data, arrayOf(set.data, name.constData()), lift, pixelRatio))
      this->addActor(label);
  if (plane)  // it hides what is below it: its border says that it is a plane
    this->addLines(this->borderOf(set), {0.75, 0.77, 0.8}, {0, 0, 0}, pixelRatio);
}

void ReceiverActors::addLines(vtkPolyData* lines, const Point& colour, const Point& lift, double pixelRatio)
{
  const auto actor = lineActor(lines, 1.2 * pixelRatio);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->SetPosition(lift[0], lift[1], lift[2]);
  this->addActor(actor);
}

void ReceiverActors::addIsolines(vtkDataSet* points, const Picture& picture, const Point& lift, double pixelRatio)
{
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(points);
  contours->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                   picture.array.toUtf8().constData());
  for (int i = 0; i < picture.isolines.size(); ++i)
    contours->SetValue(i, picture.isolines[i]);
  contours->Update();
  this->addLines(contours->GetOutput(), {1, 1, 1}, lift, pixelRatio);
  for (const auto& label : contourLabels(contours->GetOutput(), picture.array.toUtf8().constData(), lift, pixelRatio))
    this->addActor(label);
}
}  // namespace studio
