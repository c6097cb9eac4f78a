// SPDX-License-Identifier: BSD-3-Clause
#include "ConcavePolygons.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/Triangulation.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkNew.h"

namespace
{
std::vector<kalos::meshing::Point> CornersOf(vtkPolyData* input, vtkIdType count, const vtkIdType* ids)
{
  std::vector<kalos::meshing::Point> corners(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(ids[i], corners[i].data());
  }
  return corners;
}

bool AnyConcave(vtkPolyData* input)
{
  auto cells = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(count, ids);
    if (count > 3 && !kalos::meshing::isConvex(CornersOf(input, count, ids)))
    {
      return true;
    }
  }
  return false;
}

/** Puts cells and their data into the output, in order. */
struct Output
{
  vtkPolyData* input = nullptr;
  vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> origin;  ///< the cell of the input that each polygon is of

  void add(vtkIdType count, const vtkIdType* ids, vtkIdType cell)
  {
    this->polygons->InsertNextCell(count, ids);
    this->origin.push_back(cell);
  }

  void cut(vtkIdType count, const vtkIdType* ids, vtkIdType cell)
  {
    const auto corners = CornersOf(this->input, count, ids);
    if (count <= 3 || kalos::meshing::isConvex(corners))
    {
      return this->add(count, ids, cell);
    }
    const auto triangles = kalos::meshing::triangulate(corners);
    if (!triangles)
    {
      throw std::invalid_argument("surfaces: cell " + std::to_string(cell) +
                                  " is a polygon that crosses itself, expected simple polygons");
    }
    for (const auto& [a, b, c] : *triangles)
    {
      const vtkIdType triangle[3] = {ids[a], ids[b], ids[c]};
      this->add(3, triangle, cell);
    }
  }
};
}  // namespace

vtkSmartPointer<vtkPolyData> CutConcavePolygons(vtkPolyData* input)
{
  if (!AnyConcave(input))
  {
    return input;
  }
  // Cells are numbered vertices, lines, polygons, strips.
  const vtkIdType before = input->GetNumberOfVerts() + input->GetNumberOfLines();
  Output output;
  output.input = input;
  auto cells = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(count, ids);
    output.cut(count, ids, before + cells->GetCurrentCellId());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->CopyStructure(input);
  result->SetPolys(output.polygons);
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = result->GetCellData();
  to->CopyAllOn();
  to->CopyAllocate(from, result->GetNumberOfCells());
  vtkIdType next = 0;
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    to->CopyData(from, cell, next++);
  }
  for (const vtkIdType cell : output.origin)
  {
    to->CopyData(from, cell, next++);
  }
  for (vtkIdType cell = before + input->GetNumberOfPolys(); cell < input->GetNumberOfCells(); ++cell)
  {
    to->CopyData(from, cell, next++);
  }
  return result;
}
