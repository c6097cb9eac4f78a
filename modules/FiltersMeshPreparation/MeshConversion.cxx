// SPDX-License-Identifier: BSD-3-Clause
#include "MeshConversion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <sstream>
#include <string>

#include "mesh/Triangulation.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkKalosArrayLengths.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

namespace kalos
{
namespace
{
using meshing::Point;
using meshing::TriangleMesh;

void addTriangle(TriangleMesh& mesh, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
{
  mesh.triangles.push_back(
      {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  mesh.origin.push_back(static_cast<std::uint32_t>(cell));
}

/** Returns false if the polygon crosses itself and had to be cut into a fan. */
bool addPolygon(TriangleMesh& mesh, vtkIdType size, const vtkIdType* ids, vtkIdType cell)
{
  std::vector<Point> corners;
  for (vtkIdType i = 0; i < size; ++i)
  {
    corners.push_back(mesh.points[ids[i]]);
  }
  const bool convex = size == 3 || meshing::isConvex(corners);
  const auto triangles = convex ? std::nullopt : meshing::triangulate(corners);
  if (triangles)
  {
    for (const auto& [a, b, c] : *triangles)
    {
      addTriangle(mesh, ids[a], ids[b], ids[c], cell);
    }
    return true;
  }
  for (vtkIdType i = 1; i + 1 < size; ++i)
  {
    addTriangle(mesh, ids[0], ids[i], ids[i + 1], cell);
  }
  return convex;
}

void addStrip(TriangleMesh& mesh, vtkIdType size, const vtkIdType* ids, vtkIdType cell)
{
  for (vtkIdType i = 0; i + 2 < size; ++i)
  {
    const vtkIdType odd = i % 2;
    addTriangle(mesh, ids[i + odd], ids[i + 1 - odd], ids[i + 2], cell);
  }
}

bool saysWhatASurfaceIs(vtkAbstractArray* array)
{
  if (vtkStringArray::SafeDownCast(array))
  {
    return true;
  }
  auto* values = vtkDataArray::SafeDownCast(array);
  if (!values)
  {
    return false;
  }
  const int type = values->GetDataType();
  if (type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    return true;
  }
  const std::string name = array->GetName() ? array->GetName() : "";
  using namespace vtkKalosArrayNames;
  const auto names = {Reflectance, Specular, Roughness, Mirror, Exitance, Transmittance, RefractiveIndex};
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

/** A number per cell, the same for cells whose arrays agree. */
std::vector<std::uint32_t> materialsOfCells(vtkPolyData* input)
{
  const auto cells = static_cast<std::size_t>(input->GetNumberOfCells());
  std::vector<std::uint32_t> material(cells, 0);
  vtkCellData* data = input->GetCellData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (!saysWhatASurfaceIs(array))
    {
      continue;
    }
    // Refine the numbers so far by this array.
    std::map<std::pair<std::uint32_t, std::vector<double>>, std::uint32_t> numbers;
    std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> namedNumbers;
    auto* strings = vtkStringArray::SafeDownCast(array);
    auto* values = vtkDataArray::SafeDownCast(array);
    const int components = array->GetNumberOfComponents();
    std::vector<double> tuple(static_cast<std::size_t>(components));
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      const auto id = static_cast<vtkIdType>(cell);
      if (strings)
      {
        std::string text;
        for (int c = 0; c < components; ++c)
        {
          text += strings->GetValue(id * components + c) + '\n';
        }
        const auto next = static_cast<std::uint32_t>(namedNumbers.size());
        material[cell] = namedNumbers.emplace(std::make_pair(material[cell], text), next).first->second;
      }
      else
      {
        values->GetTuple(id, tuple.data());
        const auto next = static_cast<std::uint32_t>(numbers.size());
        material[cell] = numbers.emplace(std::make_pair(material[cell], tuple), next).first->second;
      }
    }
  }
  return material;
}

void checkInput(vtkPolyData* input)
{
  if (!input || !input->GetPoints() || input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    throw std::invalid_argument("the input has no polygons; expected a surface");
  }
  if (input->GetNumberOfPoints() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("the input has more than 4294967294 points; expected fewer");
  }
  vtkKalosArrayLengths::Require(input->GetCellData(), input->GetNumberOfCells(), "cells");
}
}  // namespace

ConvertedMesh convertMesh(vtkPolyData* input)
{
  checkInput(input);
  ConvertedMesh result;
  TriangleMesh& mesh = result.mesh;
  mesh.points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, mesh.points[i].data());
  }

  // Cells are numbered vertices, lines, polygons, strips.
  vtkIdType cell = result.ignored = input->GetNumberOfVerts() + input->GetNumberOfLines();
  result.polygons = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (const bool strips : {false, true})
  {
    auto items = vtk::TakeSmartPointer((strips ? input->GetStrips() : input->GetPolys())->NewIterator());
    for (items->GoToFirstCell(); !items->IsDoneWithTraversal(); items->GoToNextCell(), ++cell)
    {
      items->GetCurrentCell(size, ids);
      const bool allThere =
          std::all_of(ids, ids + size, [&](vtkIdType id) { return id >= 0 && id < input->GetNumberOfPoints(); });
      if (!allThere)
      {
        throw std::invalid_argument("cell " + std::to_string(cell) +
                                    " uses a point that is not there; expected points 0 to " +
                                    std::to_string(input->GetNumberOfPoints() - 1));
      }
      if (size < 3)
      {
        ++result.degenerate;
      }
      else if (strips)
      {
        addStrip(mesh, size, ids, cell);
      }
      else if (!addPolygon(mesh, size, ids, cell))
      {
        result.crossing.push_back(cell);
      }
    }
  }
  const std::vector<std::uint32_t> material = materialsOfCells(input);
  mesh.material.reserve(mesh.origin.size());
  for (const std::uint32_t origin : mesh.origin)
  {
    mesh.material.push_back(material[origin]);
  }
  meshing::check(mesh);
  return result;
}

void fillPolyData(const TriangleMesh& mesh, vtkPolyData* input, vtkPolyData* output)
{
  output->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].data());
  }
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                          static_cast<vtkIdType>(3 * mesh.triangles.size()));
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = output->GetCellData();
  to->CopyAllOn();
  // Normals of the input cells may be of the other side.
  if (from->GetNormals() && from->GetNormals()->GetName())
  {
    to->CopyFieldOff(from->GetNormals()->GetName());
  }
  to->CopyNormalsOff();
  to->CopyAllocate(from, static_cast<vtkIdType>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const vtkIdType corners[3] = {mesh.triangles[t][0], mesh.triangles[t][1], mesh.triangles[t][2]};
    polygons->InsertNextCell(3, corners);
    to->CopyData(from, mesh.origin[t], static_cast<vtkIdType>(t));
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetFieldData()->PassData(input->GetFieldData());
}

meshing::Progress progressOf(vtkAlgorithm* algorithm, double seconds)
{
  using Clock = std::chrono::steady_clock;
  return [algorithm, seconds, start = Clock::now()](double share) {
    if (seconds > 0.0 && std::chrono::duration<double>(Clock::now() - start).count() > seconds)
    {
      std::ostringstream text;
      text << "not done after the time limit of " << seconds
           << " s; expected a mesh with fewer defects, a longer edge length or more time";
      throw std::runtime_error(text.str());
    }
    algorithm->UpdateProgress(share);
    return !algorithm->GetAbortExecute();
  };
}

void checkTimeLimit(double seconds)
{
  if (!(seconds >= 0.0 && std::isfinite(seconds)))
  {
    throw std::invalid_argument("TimeLimit is not allowed; expected seconds above 0, or 0 for none");
  }
}

int guarded(vtkAlgorithm* algorithm, std::initializer_list<vtkDataObject*> outputs, const std::function<void()>& work)
{
  std::string message;
  try
  {
    work();
    return 1;
  }
  catch (const meshing::Stopped&)
  {
  }
  catch (const std::bad_alloc&)
  {
    message = "not enough memory; expected fewer triangles";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  for (vtkDataObject* output : outputs)
  {
    output->Initialize();
  }
  if (message.empty())
  {
    return 1;
  }
  vtkErrorWithObjectMacro(algorithm, << message);
  return 0;
}
}  // namespace kalos
