// SPDX-License-Identifier: BSD-3-Clause
#include "scene/PaintedSurface.h"

#include <cmath>
#include <vector>

#include "base/ErrorCollector.h"
#include "scene/Triangles.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkKalosSurfaceRemesh.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

namespace studio
{
namespace
{
/// Remeshing cuts polygons with holes along their outlines, which vtkTriangleFilter fills.
vtkSmartPointer<vtkPolyData> remeshed(vtkPolyData* surfaces, vtkPolyData* triangles, double length)
{
  vtkNew<vtkKalosSurfaceRemesh> remesh;
  const auto errors = ErrorCollector::watch(remesh);
  remesh->SetInputData(surfaces);
  remesh->SetEdgeLength(length);
  // Small enough along edges to show the noise of plain local estimation. Steep grading keeps the number of cells low.
  remesh->SetSmallestEdgeLength(length / 8);
  remesh->SetGrading(1.5);
  remesh->Update();
  return errors->message().isEmpty() ? remesh->GetOutput() : triangles;
}

/// Adds cell normals and splits points at creases, so that values are interpolated within a face and not
/// around its edges.
vtkSmartPointer<vtkPolyData> faceted(vtkPolyData* triangles, double crease)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(triangles);
  normals->ComputePointNormalsOn();
  normals->ComputeCellNormalsOn();
  normals->SplittingOn();
  normals->SetFeatureAngle(crease);
  normals->ConsistencyOff();
  normals->Update();
  vtkSmartPointer<vtkPolyData> result = normals->GetOutput();
  result->GetPointData()->Initialize();  // point normals would make the points the receivers
  return result;
}

/// Of triangles of a large mesh, those that stand for all.
PaintedSurface thinned(vtkPolyData* shape, double cube, vtkIdType most)
{
  vtkSmartPointer<vtkIdList> largest;
  std::vector<vtkIdType> receiverOf;  // for each triangle that stands for others, its number among these
  vtkNew<vtkIdList> chosen;
  do
  {
    largest = largestNearby(shape, cube);
    receiverOf.assign(static_cast<std::size_t>(shape->GetNumberOfCells()), -1);
    chosen->Reset();
    for (vtkIdType i = 0; i < shape->GetNumberOfCells(); ++i)
      if (largest->GetId(i) == i)
        receiverOf[static_cast<std::size_t>(i)] = chosen->InsertNextId(i);
    cube *= 1.3;
  } while (chosen->GetNumberOfIds() > most);

  PaintedSurface painted{vtkSmartPointer<vtkPolyData>::New(), shape, largest};
  for (vtkIdType i = 0; i < shape->GetNumberOfCells(); ++i)
    painted.standIns->SetId(i, receiverOf[static_cast<std::size_t>(largest->GetId(i))]);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType k = 0; k < chosen->GetNumberOfIds(); ++k)
  {
    shape->GetCellPoints(chosen->GetId(k), corners);
    cells->InsertNextCell(corners);
  }
  painted.receivers->SetPoints(shape->GetPoints());
  painted.receivers->SetPolys(cells);
  painted.receivers->GetFieldData()->ShallowCopy(shape->GetFieldData());
  copyCellData(shape, chosen, painted.receivers);
  return painted;
}
}  // namespace

PaintedSurface paintedSurface(vtkPolyData* surfaces, int cells)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surfaces);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  vtkPolyData* triangles = filter->GetOutput();
  // Half of the cells for equilateral triangles of one size; the grading along edges brings about as many again.
  const double length = std::sqrt(4 / std::sqrt(3.0) * areaOf(triangles) / (0.5 * cells));
  if (!(length > 0))
    return {triangles, triangles, nullptr};
  if (triangles->GetNumberOfCells() < cells)
  {
    const auto few = faceted(remeshed(surfaces, triangles, length), 5);
    return {few, few, nullptr};
  }
  const auto shape = faceted(cutLong(triangles, length), 30);
  if (shape->GetNumberOfCells() <= 4 * cells)
    return {shape, shape, nullptr};
  return thinned(shape, 0.5 * length, 4 * cells);
}
}  // namespace studio
