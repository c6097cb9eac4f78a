// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "../base/ErrorCatcher.h"
#include "../base/InputError.h"
#include "ObjMaterials.h"
#include "OffFile.h"
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
vtkSmartPointer<vtkPolyData> readVtpFile(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  ErrorCatcher errors(reader);
  reader->SetParserErrorObserver(errors.command());
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors.empty())
  {
    throw InputError(path, "file", "cannot be read: " + errors.firstLine() + "; expected an undamaged VTP file");
  }
  return reader->GetOutput();
}

namespace
{
Mesh fromPolyData(vtkPolyData* data, const std::string& path)
{
  if (data->GetNumberOfVerts() + data->GetNumberOfLines() + data->GetNumberOfStrips() > 0)
  {
    throw InputError(path, "cells", "vertices, lines or strips; expected polygons only");
  }
  Mesh mesh;
  mesh.points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.points[i].data());
  }
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    mesh.addPolygon(std::vector<std::int64_t>(ids, ids + size), -1);
  }
  return mesh;
}

std::vector<double> tuple(vtkDataArray* array, vtkIdType cell)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfComponents()));
  array->GetTuple(cell, values.data());
  return values;
}

bool same(const Material& a, const Material& b)
{
  return a.reflectance == b.reflectance && a.exitance == b.exitance && a.specular == b.specular &&
         a.roughness == b.roughness && a.mirror == b.mirror && a.transmittance == b.transmittance &&
         a.refractiveIndex == b.refractiveIndex;
}

/** Materials from the arrays that a VTP file carries. */
void useOwnMaterials(Mesh& mesh, vtkPolyData* data, const std::string& path)
{
  using namespace vtkKalosArrayNames;
  vtkCellData* cells = data->GetCellData();
  vtkDataArray* reflectance = cells->GetArray(Reflectance);
  vtkDataArray* exitance = cells->GetArray(Exitance);
  const auto scalar = [&](const char* name, vtkIdType cell, double absent) {
    vtkDataArray* array = cells->GetArray(name);
    return array ? array->GetComponent(cell, 0) : absent;
  };
  for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
  {
    const auto cell = static_cast<vtkIdType>(p);
    Material material;
    material.reflectance = tuple(reflectance, cell);
    if (exitance)
    {
      material.exitance = tuple(exitance, cell);
    }
    material.specular = scalar(Specular, cell, 0.0);
    material.roughness = scalar(Roughness, cell, 1.0);
    material.mirror = scalar(Mirror, cell, 0.0);
    material.transmittance = scalar(Transmittance, cell, 0.0);
    material.refractiveIndex = scalar(RefractiveIndex, cell, PlainGlass);
    const std::string problem = checkMaterial(material);
    if (!problem.empty())
    {
      throw InputError(path, "face " + std::to_string(p + 1), problem);
    }
    // Neighbours mostly share a material.
    if (mesh.palette.empty() || !same(mesh.palette.back(), material))
    {
      mesh.palette.push_back(material);
    }
    mesh.materialOf[p] = static_cast<std::int32_t>(mesh.palette.size()) - 1;
  }
}

void useFallback(const JsonCursor& place, Mesh& mesh, const Material* fallback)
{
  if (std::find(mesh.materialOf.begin(), mesh.materialOf.end(), -1) == mesh.materialOf.end())
  {
    return;
  }
  if (!fallback)
  {
    place.fail("the file has polygons without a material; expected the key \"material\" beside \"file\"");
  }
  const auto index = static_cast<std::int32_t>(mesh.palette.size());
  mesh.palette.push_back(*fallback);
  std::replace(mesh.materialOf.begin(), mesh.materialOf.end(), -1, index);
}

Mesh readObj(const std::string& path, const Materials& materials, bool required, Notes& notes)
{
  ObjFile file = readObjFile(path, notes);
  useObjMaterials(path, file, materials, required, notes);
  return std::move(file.polygons);
}
}  // namespace

Mesh readMeshFile(const JsonCursor& place, const std::string& path, const Materials& materials,
                  const Material* fallback, Notes& notes)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    place.fail("no file " + path + "; expected a mesh file, its path relative to the scene file");
  }
  std::string type = std::filesystem::path(path).extension().string();
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });

  Mesh mesh;
  if (type == ".obj")
  {
    mesh = readObj(path, materials, !fallback, notes);
  }
  else if (type == ".ply")
  {
    mesh = readPlyFile(path, notes);
  }
  else if (type == ".stl")
  {
    mesh = readStlFile(path, notes);
  }
  else if (type == ".off")
  {
    mesh = readOffFile(path);
  }
  else if (type == ".vtp")
  {
    const auto data = readVtpFile(path);
    mesh = fromPolyData(data, path);
    if (!fallback && data->GetCellData()->GetArray(vtkKalosArrayNames::Reflectance))
    {
      useOwnMaterials(mesh, data, path);
    }
  }
  else
  {
    place.fail("unknown mesh format '" + type + "'; expected .obj, .ply, .stl, .off or .vtp");
  }
  if (mesh.numberOfPolygons() == 0)
  {
    throw InputError(path, "file", "no polygons; expected at least one");
  }
  mesh.check(path, "face");
  noteDegenerate(mesh.dropDegenerate(), notes);
  if (mesh.numberOfPolygons() == 0)
  {
    throw InputError(path, "file", "none of the polygons has an area; expected at least one");
  }
  useFallback(place, mesh, fallback);
  return mesh;
}
}  // namespace kalos::scene
