// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSurfaces.h"

#include <algorithm>
#include <set>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/Names.h"
#include "../mesh/MeshFile.h"
#include "../model/ModelFile.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

namespace kalos::scene
{
namespace
{
Mesh ReadQuad(const JsonCursor& node)
{
  node.CheckKeys({"origin", "u", "v"});
  const Mesh quad = MakeQuad(node.At("origin").Vector(), node.At("u").Vector(), node.At("v").Vector());
  // The mesh check names a face; here the quad itself is the better place.
  const double sides = norm(node.At("u").Vector()) * norm(node.At("v").Vector());
  if (!(norm(quad.Area(0)) > 1e-12 * sides))
  {
    node.Fail("no area; expected u and v that are neither zero nor parallel");
  }
  return quad;
}

Mesh ReadBox(const JsonCursor& node)
{
  node.CheckKeys({"center", "size", "rotation_z_deg"});
  const Vector3 size = node.At("size").Vector();
  if (!std::all_of(size.begin(), size.end(), [](double s) { return s > 0.0; }))
  {
    node.At("size").FailExpected("three lengths above 0 m");
  }
  const auto rotation = node.Find("rotation_z_deg");
  return MakeBox(node.At("center").Vector(), size, rotation ? rotation->Number() : 0.0);
}

const Material* FindMaterial(const JsonCursor& surface, const Materials& materials)
{
  const auto node = surface.Find("material");
  if (!node)
  {
    return nullptr;
  }
  const auto found = materials.find(node->String());
  if (found == materials.end())
  {
    node->FailExpected("the name of one of \"materials\"");
  }
  return &found->second;
}

/** Where the coordinates of a file lie; without keys, glTF has y up and all others z. */
Transform ReadPlace(const JsonCursor& node, const std::string& path)
{
  const auto scale = node.Find("scale");
  const auto up = node.Find("up");
  const std::string axis = up ? up->String() : IsGltfFile(path) ? "y" : "z";
  if (axis != "y" && axis != "z")
  {
    up->FailExpected("\"y\" or \"z\"");
  }
  return UprightPlace(scale ? scale->NumberAbove(0.0) : 1.0, axis == "y");
}

/** All parts of a model as one mesh. */
Mesh Join(const Model& model)
{
  Mesh mesh;
  for (const ModelPart& part : model.Parts)
  {
    const Mesh& from = part.Polygons;
    const auto firstPoint = static_cast<std::int64_t>(mesh.Points.size());
    const auto firstCorner = static_cast<std::int64_t>(mesh.Corners.size());
    const auto firstMaterial = static_cast<std::int32_t>(mesh.Palette.size());
    mesh.Points.insert(mesh.Points.end(), from.Points.begin(), from.Points.end());
    mesh.Palette.insert(mesh.Palette.end(), from.Palette.begin(), from.Palette.end());
    for (const std::int64_t corner : from.Corners)
    {
      mesh.Corners.push_back(firstPoint + corner);
    }
    for (std::size_t p = 0; p < from.NumberOfPolygons(); ++p)
    {
      mesh.Ends.push_back(firstCorner + from.Ends[p]);
      mesh.MaterialOf.push_back(firstMaterial + from.MaterialOf[p]);
    }
  }
  return mesh;
}

Mesh ReadFile(const JsonCursor& node, const Materials& materials, const Material* material, const std::string& folder,
              Notes& notes)
{
  const JsonCursor file = node.At("file");
  const std::string path = ResolvePath(folder, file.String(), notes);
  const Transform place = ReadPlace(node, path);
  if (IsGltfFile(path))
  {
    const Model model = ReadModelFile(file, path, {place, &materials, material});
    notes.insert(notes.end(), model.Approximations.begin(), model.Approximations.end());
    return Join(model);
  }
  Mesh mesh = ReadMeshFile(file, path, materials, material, notes);
  for (Vector3& point : mesh.Points)
  {
    point = place.Point(point);
  }
  return mesh;
}

Mesh ReadPolygons(const JsonCursor& node, const Materials& materials, const std::string& folder, Notes& notes)
{
  const int shapes = int(node.Has("quad")) + int(node.Has("box")) + int(node.Has("file"));
  if (shapes != 1)
  {
    node.Fail(std::to_string(shapes) + " shapes; expected one of \"quad\", \"box\" and \"file\"");
  }
  const Material* material = FindMaterial(node, materials);
  for (const char* key : {"scale", "up"})
  {
    if (node.Has(key) && !node.Has("file"))
    {
      node.At(key).Fail("a key of a \"file\"; expected none here");
    }
  }
  if (node.Has("file"))
  {
    return ReadFile(node, materials, material, folder, notes);
  }
  if (!material)
  {
    node.Fail("the key \"material\" is missing");
  }
  const auto quad = node.Find("quad");
  Mesh mesh = quad ? ReadQuad(*quad) : ReadBox(node.At("box"));
  mesh.Palette.push_back(*material);
  std::fill(mesh.MaterialOf.begin(), mesh.MaterialOf.end(), 0);
  return mesh;
}

/** A model file whose parts are surfaces under their own names. */
void AddModel(const JsonCursor& node, const Materials& materials, const std::string& folder,
              std::set<std::string>& names, SceneSurfaces& surfaces)
{
  node.CheckKeys({"file", "material", "scale", "up", "lights", "cameras"});
  const JsonCursor file = node.At("file");
  Notes& notes = surfaces.Approximations;
  const std::string path = ResolvePath(folder, file.String(), notes);
  Model model = ReadModelFile(file, path, {ReadPlace(node, path), &materials, FindMaterial(node, materials)});
  for (ModelPart& part : model.Parts)
  {
    const std::string name = FreeName(part.Name, "surface", names);
    surfaces.All.push_back({name, node.Where() + "." + name, std::move(part.Polygons)});
  }
  const auto wanted = [&node](const char* key) { return !node.Has(key) || node.At(key).Boolean(); };
  if (wanted("lights"))
  {
    surfaces.Lights.insert(surfaces.Lights.end(), model.Lights.begin(), model.Lights.end());
  }
  if (wanted("cameras"))
  {
    surfaces.Cameras.insert(surfaces.Cameras.end(), model.Cameras.begin(), model.Cameras.end());
  }
  if (!node.Has("up"))
  {
    notes.push_back({"axes", IsGltfFile(path) ? "turned from y up to z up" : "as in the file, z up",
                     "\"up\" and \"scale\" beside \"file\" in a scene file change it"});
  }
  notes.insert(notes.end(), model.Approximations.begin(), model.Approximations.end());
  surfaces.HasModel = true;
}

std::size_t NumberOfBands(const std::vector<Surface>& surfaces)
{
  std::size_t bands = 1;
  for (const Surface& surface : surfaces)
  {
    for (const Material& material : surface.Polygons.Palette)
    {
      for (const std::size_t n : {material.Reflectance.size(), material.Exitance.size()})
      {
        if (n > 1 && bands > 1 && n != bands)
        {
          throw InputError(surface.Where + ".material", std::to_string(n) + " bands where an earlier material has " +
                                                            std::to_string(bands) + "; expected 1 or the same number");
        }
        bands = std::max(bands, n);
      }
    }
  }
  return bands;
}

vtkSmartPointer<vtkDoubleArray> NewCellArray(vtkPolyData* data, const char* name, int components, vtkIdType cells)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(cells);
  data->GetCellData()->AddArray(array);
  return array;
}
}  // namespace

SceneSurfaces ReadSurfaces(const JsonCursor& scene, const Materials& materials, const std::string& folder)
{
  SceneSurfaces surfaces;
  std::set<std::string> names;
  const auto section = scene.Find("surfaces");
  for (const JsonCursor& node : section ? section->Items() : std::vector<JsonCursor>())
  {
    const auto file = node.Find("file");
    if (file && !node.Has("name") && IsModelFile(file->String()))
    {
      AddModel(node, materials, folder, names, surfaces);
      continue;
    }
    node.CheckKeys({"name", "quad", "box", "file", "material", "scale", "up"});
    Surface surface{node.Name(), node.Where(), ReadPolygons(node, materials, folder, surfaces.Approximations)};
    if (!names.insert(surface.Name).second)
    {
      node.Fail("another surface has this name; expected a name of its own");
    }
    surfaces.All.push_back(std::move(surface));
  }
  return surfaces;
}

vtkSmartPointer<vtkPolyData> MakeSurfaceData(const std::vector<Surface>& surfaces)
{
  const auto bands = static_cast<int>(NumberOfBands(surfaces));
  vtkIdType cells = 0;
  for (const Surface& surface : surfaces)
  {
    cells += static_cast<vtkIdType>(surface.Polygons.NumberOfPolygons());
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  auto reflectance = NewCellArray(data, vtkKalosArrayNames::Reflectance, bands, cells);
  auto exitance = NewCellArray(data, vtkKalosArrayNames::Exitance, bands, cells);
  auto specular = NewCellArray(data, vtkKalosArrayNames::Specular, 1, cells);
  auto roughness = NewCellArray(data, vtkKalosArrayNames::Roughness, 1, cells);
  auto mirror = NewCellArray(data, vtkKalosArrayNames::Mirror, 1, cells);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkKalosArrayNames::SurfaceId);
  ids->SetNumberOfTuples(cells);
  data->GetCellData()->AddArray(ids);
  vtkNew<vtkStringArray> names;
  names->SetName(vtkKalosArrayNames::SurfaceNames);
  data->GetFieldData()->AddArray(names);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;

  vtkIdType cell = 0;
  for (const Surface& surface : surfaces)
  {
    const Mesh& mesh = surface.Polygons;
    const int surfaceId = static_cast<int>(names->InsertNextValue(surface.Name));
    const vtkIdType firstPoint = points->GetNumberOfPoints();
    for (const Vector3& point : mesh.Points)
    {
      points->InsertNextPoint(point.data());
    }
    for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p, ++cell)
    {
      polygons->InsertNextCell(static_cast<int>(mesh.Ends[p] - mesh.Begin(p)));
      for (std::int64_t i = mesh.Begin(p); i < mesh.Ends[p]; ++i)
      {
        polygons->InsertCellPoint(firstPoint + mesh.Corners[i]);
      }
      const Material& material = mesh.Palette[mesh.MaterialOf[p]];
      for (int b = 0; b < bands; ++b)
      {
        const std::vector<double>& rho = material.Reflectance;
        const std::vector<double>& m = material.Exitance;
        reflectance->SetComponent(cell, b, rho[rho.size() == 1 ? 0 : b]);
        exitance->SetComponent(cell, b, m[m.size() == 1 ? 0 : b]);
      }
      specular->SetValue(cell, material.Specular);
      roughness->SetValue(cell, material.Roughness);
      mirror->SetValue(cell, material.Mirror);
      ids->SetValue(cell, surfaceId);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}
}  // namespace kalos::scene
