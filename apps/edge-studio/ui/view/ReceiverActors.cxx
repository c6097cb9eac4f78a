// SPDX-License-Identifier: BSD-3-Clause
#include "view/ReceiverActors.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
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
  this->Planes.clear();
}

void ReceiverActors::clear()
{
  for (const auto& actor : this->Actors)
    this->Renderer->RemoveActor(actor);
  this->Actors.clear();
}

void ReceiverActors::addActor(vtkActor* actor)
{
  this->Renderer->AddActor(actor);
  this->Actors << actor;
}

const ReceiverActors::Plane& ReceiverActors::planeOf(const NamedSet& set)
{
  Plane& plane = this->Planes[set.name];
  if (plane.border)
    return plane;
  // It may lie on a surface, and is what one wants to see there: a hair in front of it. An offset of its depth would
  // cost more than all the rest of a picture, where software draws it.
  double normal[3];
  set.data->GetCellData()->GetNormals()->GetTuple(0, normal);
  plane.lifted = vtkSmartPointer<vtkPoints>::New();
  plane.lifted->SetNumberOfPoints(set.data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < set.data->GetNumberOfPoints(); ++i)
  {
    double at[3];
    set.data->GetPoint(i, at);
    for (int axis = 0; axis < 3; ++axis)
      at[axis] += 3e-4 * this->Scene->size() * normal[axis];
    plane.lifted->SetPoint(i, at);
  }
  // It hides what is below it: its border says that it is a plane.
  vtkNew<vtkFeatureEdges> border;
  border->SetInputData(set.data);
  border->FeatureEdgesOff();
  border->NonManifoldEdgesOff();
  border->ColoringOff();
  border->Update();
  plane.border = border->GetOutput();
  return plane;
}

void ReceiverActors::add(const NamedSet& set, const Picture& picture, bool smooth, double pixelRatio)
{
  const QByteArray name = picture.array.toUtf8();
  const bool ofPoints = hasPoints(set, name), plane = !ofPoints && isPlane(set);
  vtkNew<vtkPolyData> data;
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
    if (plane)
      data->SetPoints(this->planeOf(set).lifted);
    if (smooth || !picture.isolines.isEmpty())
    {
      vtkNew<vtkCellDataToPointData> interpolated;
      interpolated->SetInputData(data);
      interpolated->ProcessAllArraysOff();
      interpolated->AddCellDataArray(name.constData());
      interpolated->Update();
      if (!picture.isolines.isEmpty())
        this->addIsolines(interpolated->GetPolyDataOutput(), picture, pixelRatio);
      if (smooth)
        data->ShallowCopy(interpolated->GetPolyDataOutput());
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
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(static_cast<float>(7 * pixelRatio));
  actor->GetProperty()->SetBackfaceCulling(!ofPoints && !plane);
  this->addActor(actor);
  if (!plane)
    return;
  const auto border = lineActor(this->planeOf(set).border, 1.2 * pixelRatio);
  border->GetMapper()->ScalarVisibilityOff();
  border->GetProperty()->SetColor(0.75, 0.77, 0.8);
  this->addActor(border);
}

void ReceiverActors::addIsolines(vtkDataSet* points, const Picture& picture, double pixelRatio)
{
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(points);
  contours->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                   picture.array.toUtf8().constData());
  for (int i = 0; i < picture.isolines.size(); ++i)
    contours->SetValue(i, picture.isolines[i]);
  contours->Update();
  const auto actor = lineActor(contours->GetOutput(), 1.2 * pixelRatio);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(1, 1, 1);
  this->addActor(actor);
}
}  // namespace studio
