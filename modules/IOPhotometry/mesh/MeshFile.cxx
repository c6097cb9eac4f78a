// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "../base/ErrorCatcher.h"
#include "../base/InputError.h"
#include "ObjMaterials.h"
#include "PlyFile.h"
#include "StlFile.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

namespace kalos::scene
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadVtp(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  ErrorCatcher errors(reader);
  reader->SetParserErrorObserver(errors.Command());
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors.Empty())
  {
    throw InputError(path, "file", "cannot be read: " + errors.FirstLine() + "; expected an undamaged VTP file");
  }
  return reader->GetOutput();
}

Mesh FromPolyData(vtkPolyData* data, const std::string& path)
{
  if (data->GetNumberOfVerts() + data->GetNumberOfLines() + data->GetNumberOfStrips() > 0)
  {
    throw InputError(path, "cells", "vertices, lines or strips; expected polygons only");
  }
  Mesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.Points[i].data());
  }
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    mesh.AddPolygon(std::vector<std::int64_t>(ids, ids + size), -1);
  }
  return mesh;
}

std::vector<double> Tuple(vtkDataArray* array, vtkIdType cell)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(cell, values.data());
  return values;
}

bool Same(const Material& a, const Material& b)
{
  return a.Reflectance == b.Reflectance && a.Exitance == b.Exitance && a.Specular == b.Specular &&
         a.Roughness == b.Roughness && a.Mirror == b.Mirror;
}

/** Materials from the arrays that a VTP file carries. */
void UseOwnMaterials(Mesh& mesh, vtkPolyData* data, const std::string& path)
{
  using namespace vtkKalosArrayNames;
  vtkCellData* cells = data->GetCellData();
  vtkDataArray* reflectance = cells->GetArray(Reflectance);
  vtkDataArray* exitance = cells->GetArray(Exitance);
  const auto scalar = [&](const char* name, vtkIdType cell, double absent) {
    vtkDataArray* array = cells->GetArray(name);
    return array ? array->GetComponent(cell, 0) : absent;
  };
  for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const auto cell = static_cast<vtkIdType>(p);
    Material material;
    material.Reflectance = Tuple(reflectance, cell);
    if (exitance)
    {
      material.Exitance = Tuple(exitance, cell);
    }
    material.Specular = scalar(Specular, cell, 0.0);
    material.Roughness = scalar(Roughness, cell, 1.0);
    material.Mirror = scalar(Mirror, cell, 0.0);
    const std::string problem = CheckMaterial(material);
    if (!problem.empty())
    {
      throw InputError(path, "face " + std::to_string(p + 1), problem);
    }
    // Neighbours mostly share a material.
    if (mesh.Palette.empty() || !Same(mesh.Palette.back(), material))
    {
      mesh.Palette.push_back(material);
    }
    mesh.MaterialOf[p] = static_cast<std::int32_t>(mesh.Palette.size()) - 1;
  }
}

void UseFallback(const JsonCursor& place, Mesh& mesh, const Material* fallback)
{
  if (std::find(mesh.MaterialOf.begin(), mesh.MaterialOf.end(), -1) == mesh.MaterialOf.end())
  {
    return;
  }
  if (!fallback)
  {
    place.Fail("the file has polygons without a material; expected the key \"material\" beside \"file\"");
  }
  const auto index = static_cast<std::int32_t>(mesh.Palette.size());
  mesh.Palette.push_back(*fallback);
  std::replace(mesh.MaterialOf.begin(), mesh.MaterialOf.end(), -1, index);
}

Mesh ReadObj(const std::string& path, const Materials& materials, Notes& notes)
{
  ObjFile file = ReadObjFile(path);
  file.Polygons.Palette = FindObjMaterials(path, file, materials, notes);
  return std::move(file.Polygons);
}
}  // namespace

Mesh ReadMeshFile(const JsonCursor& place, const std::string& path, const Materials& materials,
                  const Material* fallback, Notes& notes)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    place.Fail("no file " + path + "; expected a mesh file, its path relative to the scene file");
  }
  std::string type = std::filesystem::path(path).extension().string();
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });

  Mesh mesh;
  if (type == ".obj")
  {
    mesh = ReadObj(path, materials, notes);
  }
  else if (type == ".ply")
  {
    mesh = ReadPlyFile(path);
  }
  else if (type == ".stl")
  {
    mesh = ReadStlFile(path);
  }
  else if (type == ".vtp")
  {
    const auto data = ReadVtp(path);
    mesh = FromPolyData(data, path);
    if (!fallback && data->GetCellData()->GetArray(vtkKalosArrayNames::Reflectance))
    {
      UseOwnMaterials(mesh, data, path);
    }
  }
  else
  {
    place.Fail("unknown mesh format '" + type + "'; expected .obj, .ply, .stl or .vtp");
  }
  if (mesh.NumberOfPolygons() == 0)
  {
    throw InputError(path, "file", "no polygons; expected at least one");
  }
  mesh.Check(path, "face");
  UseFallback(place, mesh, fallback);
  return mesh;
}
}  // namespace kalos::scene
