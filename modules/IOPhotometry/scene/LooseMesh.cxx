// SPDX-License-Identifier: BSD-3-Clause
#include "LooseMesh.h"

#include <algorithm>
#include <filesystem>

#include "../base/InputError.h"
#include "../base/TextLines.h"
#include "../mesh/MeshFile.h"
#include "../mesh/ObjFile.h"
#include "../mesh/OffFile.h"
#include "../mesh/PlyFile.h"
#include "../mesh/StlFile.h"
#include "../model/ModelFile.h"
#include "ModelScene.h"
#include "SceneSurfaces.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

namespace kalos::scene
{
namespace
{
vtkSmartPointer<vtkPolyData> makePolyData(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& point : mesh.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
  {
    polygons->InsertNextCell(static_cast<int>(mesh.ends[p] - mesh.begin(p)));
    for (std::int64_t i = mesh.begin(p); i < mesh.ends[p]; ++i)
    {
      polygons->InsertCellPoint(mesh.corners[i]);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

/** The names of materials, and their numbers on the cells; an empty name for cells without. */
void addNames(const ObjFile& file, vtkPolyData* data)
{
  vtkNew<vtkStringArray> names;
  names->SetName("MaterialNames");
  for (const std::string& name : file.materialNames)
  {
    names->InsertNextValue(name);
  }
  const std::vector<std::int32_t>& of = file.polygons.materialOf;
  const auto unnamed = static_cast<int>(file.materialNames.size());
  if (std::count(of.begin(), of.end(), -1) > 0)
  {
    names->InsertNextValue("");
  }
  vtkNew<vtkIntArray> ids;
  ids->SetName("MaterialIds");
  for (const std::int32_t material : of)
  {
    ids->InsertNextValue(material < 0 ? unnamed : material);
  }
  data->GetCellData()->AddArray(ids);
  data->GetFieldData()->AddArray(names);
}

vtkSmartPointer<vtkPolyData> readGltf(const std::string& path, Notes& notes)
{
  const nlohmann::json name = path;
  const Materials none;
  ModelUse use;
  use.place = uprightPlace(1.0, true);
  use.overrides = &none;
  const Model model = readModelFile(JsonCursor(name, "file"), path, use);
  notes = model.approximations;
  std::vector<Surface> surfaces;
  for (const ModelPart& part : model.parts)
  {
    surfaces.push_back({part.name, "file", part.polygons});
  }
  return makeSurfaceData(surfaces);
}

vtkSmartPointer<vtkPolyData> readPolygons(const std::string& path, const std::string& type, Notes& notes)
{
  if (type == ".obj")
  {
    const ObjFile file = readObjFile(path, notes, Reading::Lenient);
    file.polygons.check(path, "face");
    const auto data = makePolyData(file.polygons);
    addNames(file, data);
    return data;
  }
  const Mesh mesh = type == ".ply"   ? readPlyFile(path, notes)
                    : type == ".stl" ? readStlFile(path, notes)
                                     : readOffFile(path);
  mesh.check(path, "face");
  return makePolyData(mesh);
}
}  // namespace

vtkSmartPointer<vtkPolyData> readLooseMesh(const std::string& path)
{
  const std::string type = lowerCase(std::filesystem::path(path).extension().string());
  const bool polygons = type == ".obj" || type == ".ply" || type == ".stl" || type == ".off";
  if (!polygons && type != ".vtp" && !isGltfFile(path))
  {
    throw InputError(path, "name",
                     "unknown format '" + quotable(type) + "'; expected .obj, .ply, .stl, .off, .vtp, .gltf or .glb");
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
  {
    throw InputError(path, "file", "is not there; expected a mesh file");
  }
  Notes notes;
  const auto data = isGltfFile(path) ? readGltf(path, notes)
                    : polygons       ? readPolygons(path, type, notes)
                                     : readVtpFile(path);
  if (data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    throw InputError(path, "file", "no polygons; expected at least one");
  }
  if (!notes.empty())
  {
    putNotes(notes, data);
  }
  return data;
}
}  // namespace kalos::scene
