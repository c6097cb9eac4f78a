// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Furnace.h"

#include <cmath>

#include "base/DataSets.h"
#include "base/ErrorCollector.h"
#include "base/Point.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosSingularEdges.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolygon.h"
#include "vtkReverseSense.h"
#include "vtkStaticCellLocator.h"

namespace studio
{
namespace
{
void addEdgeDistances(vtkMultiBlockDataSet* receivers, vtkDataObject* measured)
{
  const QVector<NamedSet> from = dataSets(measured), to = dataSets(receivers);
  for (int i = 0; i < std::min(from.size(), to.size()); ++i)
  {
    const auto copy = [](vtkDataSetAttributes* source, vtkDataSetAttributes* target) {
      if (vtkDataArray* distance = source->GetArray(vtkKalosArrayNames::EdgeDistance))
        target->AddArray(distance);
    };
    copy(from[i].data->GetPointData(), to[i].data->GetPointData());
    copy(from[i].data->GetCellData(), to[i].data->GetCellData());
  }
}
}  // namespace

vtkSmartPointer<vtkPolyData> singularEdges(vtkPolyData* surfaces, bool borders, vtkMultiBlockDataSet* receivers)
{
  vtkNew<vtkKalosSingularEdges> edges;
  const auto errors = ErrorCollector::watch(edges);
  edges->SetInputData(surfaces);
  edges->SetBorderEdges(borders);
  if (receivers)
    edges->SetInputDataObject(1, receivers);
  edges->Update();
  if (receivers)
    addEdgeDistances(receivers, edges->GetOutputDataObject(1));
  return edges->GetOutput();
}

namespace
{
/// The one value that all cells have in all components; none if they differ.
std::optional<double> uniform(vtkPolyData* surfaces, const char* name)
{
  vtkDataArray* array = surfaces->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() == 0)
    return {};
  const double first = array->GetComponent(0, 0);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      if (array->GetComponent(i, c) != first)
        return {};
  return first;
}

bool isClosed(vtkPolyData* surfaces)
{
  const auto edges = singularEdges(surfaces, true);
  auto* classes =
      vtkIntArray::SafeDownCast(edges->GetCellData()->GetArray(vtkKalosSingularEdges::EdgeClassArrayName()));
  for (vtkIdType i = 0; classes && i < classes->GetNumberOfTuples(); ++i)
    if (classes->GetValue(i) == vtkKalosSingularEdges::BORDER)
      return false;
  return classes != nullptr;
}

Point normalOf(vtkPolyData* surfaces, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  surfaces->GetCellPoints(cell, corners);
  Point normal(0, 0, 0);
  vtkPolygon::ComputeNormal(surfaces->GetPoints(), static_cast<int>(corners->GetNumberOfIds()), corners->GetPointer(0),
                            normal.GetData());
  return normal;
}

/// Whether rays from one side of every face (of many: of 2000) meet that side of the next face. One ray in a hundred
/// may slip through between two faces.
bool seesOnlyItself(vtkPolyData* surfaces, double side)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surfaces);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  const double size = surfaces->GetLength();
  constexpr int directions = 6;
  const vtkIdType step = surfaces->GetNumberOfCells() / 2000 + 1;
  vtkIdType rays = 0, lost = 0;
  for (vtkIdType i = 0; i < surfaces->GetNumberOfCells(); i += step)
  {
    const Point front = side * normalOf(surfaces, i), centre = cellCentre(surfaces, i);
    Point u, v;
    vtkMath::Perpendiculars(front.GetData(), u.GetData(), v.GetData(), 0.1);
    for (int k = 0; k < directions; ++k, ++rays)
    {
      const double turn = 2 * vtkMath::Pi() * (k + 0.3) / directions, slope = 0.2 + 0.3 * k;
      const Point way = (front + slope * (std::cos(turn) * u + std::sin(turn) * v)).Normalized();
      const Point from = centre + 1e-6 * size * front, to = from + 2 * size * way;
      double t, hit[3], parameters[3];
      int part;
      vtkIdType met;
      if (!locator->IntersectWithLine(from.GetData(), to.GetData(), 1e-9 * size, t, hit, parameters, part, met, cell))
        ++lost;
      else if (side * way.Dot(normalOf(surfaces, met)) > 0)
        return false;
    }
  }
  return rays > 0 && 100 * lost <= rays;
}
}  // namespace

std::optional<double> furnaceIlluminance(vtkPolyData* surfaces, vtkPolyData* luminaires)
{
  namespace Names = vtkKalosArrayNames;
  const auto reflectance = uniform(surfaces, Names::Reflectance), exitance = uniform(surfaces, Names::Exitance);
  for (const char* other : {Names::Specular, Names::Mirror})
    if (surfaces->GetCellData()->HasArray(other) && uniform(surfaces, other) != 0.0)
      return {};
  if (!reflectance || !exitance || !(*exitance > 0) || luminaires->GetNumberOfPoints() > 0 || !isClosed(surfaces) ||
      !seesOnlyItself(surfaces, 1))
    return {};
  return *exitance / (1 - *reflectance);
}

bool facesOutward(vtkPolyData* surfaces)
{
  return isClosed(surfaces) && seesOnlyItself(surfaces, -1);
}

vtkSmartPointer<vtkPolyData> turned(vtkPolyData* surfaces)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surfaces);
  reverse->ReverseCellsOn();
  reverse->ReverseNormalsOn();
  reverse->Update();
  return reverse->GetOutput();
}
}  // namespace studio
