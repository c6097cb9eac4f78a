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
Mesh readQuad(const JsonCursor& node)
{
  node.checkKeys({"origin", "u", "v"});
  const Mesh quad = makeQuad(node.at("origin").vector(), node.at("u").vector(), node.at("v").vector());
  // The mesh check names a face; here the quad itself is the better place.
  const double sides = norm(node.at("u").vector()) * norm(node.at("v").vector());
  if (!(norm(quad.area(0)) > 1e-12 * sides))
  {
    node.fail("no area; expected u and v that are neither zero nor parallel");
  }
  return quad;
}

Mesh readBox(const JsonCursor& node)
{
  node.checkKeys({"center", "size", "rotation_z_deg"});
  const Vector3 size = node.at("size").vector();
  if (!std::all_of(size.begin(), size.end(), [](double s) { return s > 0.0; }))
  {
    node.at("size").failExpected("three lengths above 0 m");
  }
  const auto rotation = node.find("rotation_z_deg");
  return makeBox(node.at("center").vector(), size, rotation ? rotation->number() : 0.0);
}

const Material* findMaterial(const JsonCursor& surface, const Materials& materials)
{
  const auto node = surface.find("material");
  if (!node)
  {
    return nullptr;
  }
  const auto found = materials.find(node->string());
  if (found == materials.end())
  {
    node->failExpected("the name of one of \"materials\"");
  }
  return &found->second;
}

/** Where the coordinates of a file lie; without keys, glTF has y up and all others z. */
Transform readPlace(const JsonCursor& node, const std::string& path)
{
  const auto scale = node.find("scale");
  const auto up = node.find("up");
  const std::string axis = up ? up->string() : isGltfFile(path) ? "y" : "z";
  if (axis != "y" && axis != "z")
  {
    up->failExpected("\"y\" or \"z\"");
  }
  return uprightPlace(scale ? scale->numberAbove(0.0) : 1.0, axis == "y");
}

/** All parts of a model as one mesh. */
Mesh join(const Model& model)
{
  Mesh mesh;
  for (const ModelPart& part : model.parts)
  {
    const Mesh& from = part.polygons;
    const auto firstPoint = static_cast<std::int64_t>(mesh.points.size());
    const auto firstCorner = static_cast<std::int64_t>(mesh.corners.size());
    const auto firstMaterial = static_cast<std::int32_t>(mesh.palette.size());
    mesh.points.insert(mesh.points.end(), from.points.begin(), from.points.end());
    mesh.palette.insert(mesh.palette.end(), from.palette.begin(), from.palette.end());
    for (const std::int64_t corner : from.corners)
    {
      mesh.corners.push_back(firstPoint + corner);
    }
    for (std::size_t p = 0; p < from.numberOfPolygons(); ++p)
    {
      mesh.ends.push_back(firstCorner + from.ends[p]);
      mesh.materialOf.push_back(firstMaterial + from.materialOf[p]);
    }
  }
  return mesh;
}

Mesh readFile(const JsonCursor& node, const Materials& materials, const Material* material, const std::string& folder,
              Notes& notes)
{
  const JsonCursor file = node.at("file");
  const std::string path = resolvePath(folder, file.string(), notes);
  const Transform place = readPlace(node, path);
  if (isGltfFile(path))
  {
    const Model model = readModelFile(file, path, {place, &materials, material});
    notes.insert(notes.end(), model.approximations.begin(), model.approximations.end());
    return join(model);
  }
  Mesh mesh = readMeshFile(file, path, materials, material, notes);
  for (Vector3& point : mesh.points)
  {
    point = place.point(point);
  }
  return mesh;
}

Mesh readPolygons(const JsonCursor& node, const Materials& materials, const std::string& folder, Notes& notes)
{
  const int shapes = int(node.has("quad")) + int(node.has("box")) + int(node.has("file"));
  if (shapes != 1)
  {
    node.fail(std::to_string(shapes) + " shapes; expected one of \"quad\", \"box\" and \"file\"");
  }
  const Material* material = findMaterial(node, materials);
  for (const char* key : {"scale", "up"})
  {
    if (node.has(key) && !node.has("file"))
    {
      node.at(key).fail("a key of a \"file\"; expected none here");
    }
  }
  if (node.has("file"))
  {
    return readFile(node, materials, material, folder, notes);
  }
  if (!material)
  {
    node.fail("the key \"material\" is missing");
  }
  const auto quad = node.find("quad");
  Mesh mesh = quad ? readQuad(*quad) : readBox(node.at("box"));
  mesh.palette.push_back(*material);
  std::fill(mesh.materialOf.begin(), mesh.materialOf.end(), 0);
  return mesh;
}

/** A model file whose parts are surfaces under their own names. */
void addModel(const JsonCursor& node, const Materials& materials, const std::string& folder,
              std::set<std::string>& names, SceneSurfaces& surfaces)
{
  node.checkKeys({"file", "material", "scale", "up", "lights", "cameras"});
  const JsonCursor file = node.at("file");
  Notes& notes = surfaces.approximations;
  const std::string path = resolvePath(folder, file.string(), notes);
  Model model = readModelFile(file, path, {readPlace(node, path), &materials, findMaterial(node, materials)});
  for (ModelPart& part : model.parts)
  {
    const std::string name = freeName(part.name, "surface", names);
    surfaces.all.push_back({name, node.where() + "." + name, std::move(part.polygons)});
  }
  const auto wanted = [&node](const char* key) { return !node.has(key) || node.at(key).boolean(); };
  if (wanted("lights"))
  {
    surfaces.lights.insert(surfaces.lights.end(), model.lights.begin(), model.lights.end());
  }
  if (wanted("cameras"))
  {
    surfaces.cameras.insert(surfaces.cameras.end(), model.cameras.begin(), model.cameras.end());
  }
  if (!node.has("up"))
  {
    notes.push_back({"axes", isGltfFile(path) ? "turned from y up to z up" : "as in the file, z up",
                     "\"up\" and \"scale\" beside \"file\" in a scene file change it"});
  }
  notes.insert(notes.end(), model.approximations.begin(), model.approximations.end());
  surfaces.hasModel = true;
}

std::size_t numberOfBands(const std::vector<Surface>& surfaces)
{
  std::size_t bands = 1;
  for (const Surface& surface : surfaces)
  {
    for (const Material& material : surface.polygons.palette)
    {
      for (const std::size_t n : {material.reflectance.size(), material.exitance.size()})
      {
        if (n > 1 && bands > 1 && n != bands)
        {
          throw InputError(surface.where + ".material", std::to_string(n) + " bands where an earlier material has " +
                                                            std::to_string(bands) + "; expected 1 or the same number");
        }
        bands = std::max(bands, n);
      }
    }
  }
  return bands;
}

vtkSmartPointer<vtkDoubleArray> newCellArray(vtkPolyData* data, const char* name, int components, vtkIdType cells)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(cells);
  data->GetCellData()->AddArray(array);
  return array;
}
}  // namespace

SceneSurfaces readSurfaces(const JsonCursor& scene, const Materials& materials, const std::string& folder)
{
  SceneSurfaces surfaces;
  std::set<std::string> names;
  const auto section = scene.find("surfaces");
  for (const JsonCursor& node : section ? section->items() : std::vector<JsonCursor>())
  {
    const auto file = node.find("file");
    if (file && !node.has("name") && isModelFile(file->string()))
    {
      addModel(node, materials, folder, names, surfaces);
      continue;
    }
    node.checkKeys({"name", "quad", "box", "file", "material", "scale", "up"});
    Surface surface{node.name(), node.where(), readPolygons(node, materials, folder, surfaces.approximations)};
    if (!names.insert(surface.name).second)
    {
      node.fail("another surface has this name; expected a name of its own");
    }
    surfaces.all.push_back(std::move(surface));
  }
  return surfaces;
}

vtkSmartPointer<vtkPolyData> makeSurfaceData(const std::vector<Surface>& surfaces)
{
  const auto bands = static_cast<int>(numberOfBands(surfaces));
  vtkIdType cells = 0;
  for (const Surface& surface : surfaces)
  {
    cells += static_cast<vtkIdType>(surface.polygons.numberOfPolygons());
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  auto reflectance = newCellArray(data, vtkKalosArrayNames::Reflectance, bands, cells);
  auto exitance = newCellArray(data, vtkKalosArrayNames::Exitance, bands, cells);
  auto specular = newCellArray(data, vtkKalosArrayNames::Specular, 1, cells);
  auto roughness = newCellArray(data, vtkKalosArrayNames::Roughness, 1, cells);
  auto mirror = newCellArray(data, vtkKalosArrayNames::Mirror, 1, cells);
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
    const Mesh& mesh = surface.polygons;
    const int surfaceId = static_cast<int>(names->InsertNextValue(surface.name));
    const vtkIdType firstPoint = points->GetNumberOfPoints();
    for (const Vector3& point : mesh.points)
    {
      points->InsertNextPoint(point.data());
    }
    for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p, ++cell)
    {
      polygons->InsertNextCell(static_cast<int>(mesh.ends[p] - mesh.begin(p)));
      for (std::int64_t i = mesh.begin(p); i < mesh.ends[p]; ++i)
      {
        polygons->InsertCellPoint(firstPoint + mesh.corners[i]);
      }
      const Material& material = mesh.palette[mesh.materialOf[p]];
      for (int b = 0; b < bands; ++b)
      {
        const std::vector<double>& rho = material.reflectance;
        const std::vector<double>& m = material.exitance;
        reflectance->SetComponent(cell, b, rho[rho.size() == 1 ? 0 : b]);
        exitance->SetComponent(cell, b, m[m.size() == 1 ? 0 : b]);
      }
      specular->SetValue(cell, material.specular);
      roughness->SetValue(cell, material.roughness);
      mirror->SetValue(cell, material.mirror);
      ids->SetValue(cell, surfaceId);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}
}  // namespace kalos::scene
