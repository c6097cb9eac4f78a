// SPDX-License-Identifier: BSD-3-Clause
#include "PaintedSurface.h"

#include <cmath>

#include "ErrorCollector.h"
#include "vtkKalosSurfaceRemesh.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

namespace studio
{
namespace
{
double area(vtkPolyData* triangles)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(triangles);
  return properties->GetSurfaceArea();
}

vtkSmartPointer<vtkPolyData> cut(vtkPolyData* triangles, int cells)
{
  if (triangles->GetNumberOfCells() >= cells)
    return triangles;
  // Half of the cells for equilateral triangles of one size, the other half for the grading along edges.
  const double length = std::sqrt(4 / std::sqrt(3.0) * area(triangles) / (0.5 * cells));
  if (!(length > 0))
    return triangles;
  vtkNew<vtkKalosSurfaceRemesh> remesh;
  const auto errors = ErrorCollector::watch(remesh);
  remesh->SetInputData(triangles);
  remesh->SetEdgeLength(length);
  remesh->SetSmallestEdgeLength(length / 3);
  remesh->Update();
  return errors->message().isEmpty() ? remesh->GetOutput() : triangles;
}
}  // namespace

vtkSmartPointer<vtkPolyData> paintedSurface(vtkPolyData* surfaces, int cells)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surfaces);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();

  // Points are not shared across creases, so that values can be interpolated within a face and not around its edges.
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(cut(triangles->GetOutput(), cells));
  normals->ComputePointNormalsOn();
  normals->ComputeCellNormalsOn();
  normals->SplittingOn();
  normals->SetFeatureAngle(5);
  normals->ConsistencyOff();
  normals->Update();
  vtkSmartPointer<vtkPolyData> painted = normals->GetOutput();
  painted->GetPointData()->Initialize();  // point normals would make the points the receivers
  return painted;
}
}  // namespace studio
