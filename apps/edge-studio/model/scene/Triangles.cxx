// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/DataSets.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTriangle.h"

namespace studio
{
namespace
{
using Corners = std::array<vtkIdType, 3>;

Corners cornersOf(vtkPolyData* data, vtkIdType cell)
{
  vtkIdType count;
  const vtkIdType* ids;
  data->GetCellPoints(cell, count, ids);
  return {ids[0], ids[1], ids[2]};
}

double area(vtkPolyData* data, vtkIdType cell)
{
  double p[3][3];
  const Corners corners = cornersOf(data, cell);
  for (int k = 0; k < 3; ++k)
    data->GetPoint(corners[k], p[k]);
  return vtkTriangle::TriangleArea(p[0], p[1], p[2]);
}

/// Halves triangles; neighbours share the new points.
class Cutter
{
public:
  Cutter(vtkPoints* points, double longest) : Points(points), Squared(longest * longest) {}

  void cut(const Corners& corners, std::vector<Corners>& pieces)
  {
    int first = 0;
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      if (const double squared = this->squaredLength(corners[k], corners[(k + 1) % 3]); squared > longest)
      {
        longest = squared;
        first = k;
      }
    if (!(longest > this->Squared))
      return pieces.push_back(corners);
    const vtkIdType a = corners[first], b = corners[(first + 1) % 3], c = corners[(first + 2) % 3],
                    m = this->middle(a, b);
    this->cut({a, m, c}, pieces);
    this->cut({m, b, c}, pieces);
  }

private:
  Point at(vtkIdType point) const { return Point(this->Points->GetPoint(point)); }
  double squaredLength(vtkIdType a, vtkIdType b) const { return (this->at(b) - this->at(a)).SquaredNorm(); }

  vtkIdType middle(vtkIdType a, vtkIdType b)
  {
    const auto [entry, isNew] = this->Middles.try_emplace(std::minmax(a, b), 0);
    if (isNew)
      entry->second = this->Points->InsertNextPoint((0.5 * (this->at(a) + this->at(b))).GetData());
    return entry->second;
  }

  vtkPoints* Points;
  double Squared;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Middles;
};
}  // namespace

double areaOf(vtkPolyData* triangles)
{
  double sum = 0;
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
    sum += area(triangles, i);
  return sum;
}

void copyCellData(vtkPolyData* from, vtkIdList* cells, vtkPolyData* to)
{
  vtkCellData* data = to->GetCellData();
  data->CopyAllocate(from->GetCellData(), cells->GetNumberOfIds());
  for (vtkIdType k = 0; k < cells->GetNumberOfIds(); ++k)  // one by one: VTK 9.1 crashes over a list
    data->CopyData(from->GetCellData(), cells->GetId(k), k);
}

vtkSmartPointer<vtkPolyData> cutLong(vtkPolyData* triangles, double longest)
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(triangles->GetPoints());
  vtkNew<vtkCellArray> cells;
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkIdList> origins;
  Cutter cutter(points, longest);
  std::vector<Corners> pieces;
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    pieces.clear();
    cutter.cut(cornersOf(triangles, i), pieces);
    for (const Corners& piece : pieces)
    {
      cells->InsertNextCell(3, piece.data());
      origins->InsertNextId(i);
    }
  }
  result->SetPoints(points);
  result->SetPolys(cells);
  result->GetFieldData()->ShallowCopy(triangles->GetFieldData());
  copyCellData(triangles, origins, result);
  return result;
}

int facing(vtkDataArray* normals, vtkIdType cell)
{
  double n[3];
  normals->GetTuple(cell, n);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    axis = std::abs(n[i]) > std::abs(n[axis]) ? i : axis;
  return 2 * axis + (n[axis] < 0 ? 1 : 0);
}

vtkSmartPointer<vtkIdList> largestNearby(vtkPolyData* triangles, double cube)
{
  struct Largest
  {
    vtkIdType triangle;
    double area;
  };
  using Place = std::array<double, 5>;  // cube, direction, reflectance
  std::map<Place, Largest> largest;
  std::vector<const Largest*> mine;
  vtkDataArray *normals = triangles->GetCellData()->GetNormals(),
               *reflectance = triangles->GetCellData()->GetArray(vtkKalosArrayNames::Reflectance);
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    const Point at = cellCentre(triangles, i);
    double code = 0;
    for (int c = 0; reflectance && c < reflectance->GetNumberOfComponents(); ++c)
      code = 3 * code + reflectance->GetComponent(i, c);
    const double size = area(triangles, i);
    const Place place{std::floor(at[0] / cube), std::floor(at[1] / cube), std::floor(at[2] / cube),
                      static_cast<double>(facing(normals, i)), code};
    Largest& here = largest.try_emplace(place, Largest{i, size}).first->second;
    if (size > here.area)
      here = {i, size};
    mine.push_back(&here);
  }
  auto standIns = vtkSmartPointer<vtkIdList>::New();
  standIns->SetNumberOfIds(triangles->GetNumberOfCells());
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
    standIns->SetId(i, mine[static_cast<std::size_t>(i)]->triangle);
  return standIns;
}
}  // namespace studio
