// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSurfaces.h"

#include <algorithm>
#include <set>

#include "../base/InputError.h"
#include "../model/ModelFile.h"
#include "SceneModels.h"
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
  // The mesh check would name a face; the key of the quad is more helpful.
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
    return readSurfaceFile(node, materials, material, folder, notes);
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

namespace
{
// The arrays of materials, one value or one per band for each cell.
class MaterialArrays
{
public:
  MaterialArrays(vtkPolyData* data, int bands, vtkIdType cells, bool glass)
      : Bands(bands),
        Reflectance(newCellArray(data, vtkKalosArrayNames::Reflectance, bands, cells)),
        Exitance(newCellArray(data, vtkKalosArrayNames::Exitance, bands, cells)),
        Specular(newCellArray(data, vtkKalosArrayNames::Specular, 1, cells)),
        Roughness(newCellArray(data, vtkKalosArrayNames::Roughness, 1, cells)),
        Mirror(newCellArray(data, vtkKalosArrayNames::Mirror, 1, cells))
  {
    if (glass)
    {
      this->Transmittance = newCellArray(data, vtkKalosArrayNames::Transmittance, 1, cells);
      this->RefractiveIndex = newCellArray(data, vtkKalosArrayNames::RefractiveIndex, 1, cells);
    }
  }

  void set(vtkIdType cell, const Material& material)
  {
    const std::vector<double>& rho = material.reflectance;
    const std::vector<double>& m = material.exitance;
    for (int b = 0; b < this->Bands; ++b)
    {
      this->Reflectance->SetComponent(cell, b, rho[rho.size() == 1 ? 0 : b]);
      this->Exitance->SetComponent(cell, b, m[m.size() == 1 ? 0 : b]);
    }
    this->Specular->SetValue(cell, material.specular);
    this->Roughness->SetValue(cell, material.roughness);
    this->Mirror->SetValue(cell, material.mirror);
    if (this->Transmittance)
    {
      this->Transmittance->SetValue(cell, material.transmittance);
      this->RefractiveIndex->SetValue(cell, material.refractiveIndex);
    }
  }

private:
  int Bands;
  vtkSmartPointer<vtkDoubleArray> Reflectance, Exitance, Specular, Roughness, Mirror;
  vtkSmartPointer<vtkDoubleArray> Transmittance, RefractiveIndex;  // only where there is glass
};

bool hasGlass(const std::vector<Surface>& surfaces)
{
  return std::any_of(surfaces.begin(), surfaces.end(), [](const Surface& surface) {
    const std::vector<Material>& all = surface.polygons.palette;
    return std::any_of(all.begin(), all.end(), [](const Material& material) { return material.transmittance > 0.0; });
  });
}
}  // namespace

vtkSmartPointer<vtkPolyData> makeSurfaceData(const std::vector<Surface>& surfaces)
{
  vtkIdType cells = 0;
  for (const Surface& surface : surfaces)
  {
    cells += static_cast<vtkIdType>(surface.polygons.numberOfPolygons());
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  MaterialArrays materials(data, static_cast<int>(numberOfBands(surfaces)), cells, hasGlass(surfaces));
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
      materials.set(cell, mesh.palette[mesh.materialOf[p]]);
      ids->SetValue(cell, surfaceId);
    }
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}
}  // namespace kalos::scene
