// SPDX-License-Identifier: BSD-3-Clause
#include "SceneConversion.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

#include "ConcavePolygons.h"
#include "ConversionErrors.h"
#include "LuminaireConversion.h"
#include "SkyConversion.h"
#include "SurfaceJoining.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayLengths.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

namespace
{
namespace Names = vtkKalosArrayNames;

/// One value per band from an array of 1 or `bands` components.
kalos::Bands ReadBands(vtkDataArray* array, vtkIdType cell, int bands, double below)
{
  kalos::Bands values{};
  for (int b = 0; b < bands; ++b)
  {
    const double v = array->GetComponent(cell, array->GetNumberOfComponents() == 1 ? 0 : b);
    if (!(v >= 0 && v < below))
      Refuse(array->GetName(), "cell", cell,
             "is " + std::to_string(v) + ", expected a number in [0, " + (below == 1 ? "1)" : "infinity)"));
    values[b] = v;
  }
  return values;
}

int CountBands(vtkDataArray* array, int bands)
{
  const int n = array ? array->GetNumberOfComponents() : 1;
  if (n > kalos::maxBands)
    throw std::invalid_argument(std::string(array->GetName()) + ": has " + std::to_string(n) +
                                " components, expected at most " + std::to_string(kalos::maxBands));
  if (n != 1 && bands != 1 && n != bands)
    throw std::invalid_argument(std::string(array->GetName()) + ": has " + std::to_string(n) +
                                " components, expected 1 or " + std::to_string(bands));
  return std::max(n, bands);
}

double ReadNumber(vtkDataArray* array, vtkIdType cell, double absent, double highest)
{
  if (!array)
    return absent;
  const double v = array->GetComponent(cell, 0);
  if (!(v >= 0 && v <= highest))
    Refuse(array->GetName(), "cell", cell, "is " + std::to_string(v) + ", expected a number from 0 to 1");
  return v;
}

constexpr double plainGlass = 1.52;  // refractive index

kalos::Material ReadMaterial(vtkCellData* data, vtkIdType cell, int bands)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  kalos::Material material;
  material.reflectance = ReadBands(data->GetArray(Names::Reflectance), cell, bands, 1);
  if (vtkDataArray* exitance = data->GetArray(Names::Exitance))
    material.exitance = ReadBands(exitance, cell, bands, unlimited);
  material.specular = ReadNumber(data->GetArray(Names::Specular), cell, 0, 1);
  material.roughness = ReadNumber(data->GetArray(Names::Roughness), cell, 1, 1);
  material.mirror = ReadNumber(data->GetArray(Names::Mirror), cell, 0, 1);
  if (const double transmittance = ReadNumber(data->GetArray(Names::Transmittance), cell, 0, 1); transmittance > 0)
  {
    vtkDataArray* index = data->GetArray(Names::RefractiveIndex);
    try
    {
      material.glass =
          std::make_shared<const kalos::Glass>(transmittance, index ? index->GetComponent(cell, 0) : plainGlass);
    }
    catch (const std::invalid_argument& error)
    {
      Refuse(Names::Transmittance, "cell", cell, error.what());
    }
    return material;
  }
  for (int b = 0; b < bands; ++b)
    if (!(material.reflectance[b] + material.specular + material.mirror < 1))
      Refuse(Names::Reflectance, "cell", cell, "with Specular and Mirror must sum to less than 1");
  if (material.specular > 0 && !(material.roughness > 0))
    Refuse(Names::Roughness, "cell", cell, "is 0, expected a number in (0, 1]; use Mirror for a perfect mirror");
  return material;
}

using MaterialKey = std::tuple<kalos::Bands, kalos::Bands, double, double, double, double, double>;

MaterialKey KeyOf(const kalos::Material& m)
{
  return {m.reflectance,
          m.exitance,
          m.specular,
          m.roughness,
          m.mirror,
          m.glass ? m.glass->normalTransmittance() : 0,
          m.glass ? m.glass->refractiveIndex() : 0};
}

/// The triangulation leaves out polygons without area and those it cannot cut; nothing is dropped silently.
void RefuseLostPolygons(vtkPolyData* input, vtkPolyData* triangles)
{
  vtkIdType expected = input->GetPolys()->GetNumberOfConnectivityIds() - 2 * input->GetNumberOfPolys();
  expected += input->GetStrips()->GetNumberOfConnectivityIds() - 2 * input->GetNumberOfStrips();
  const vtkIdType lost = expected - triangles->GetNumberOfPolys();
  if (lost > 0)
    throw std::invalid_argument("surfaces: polygons worth " + std::to_string(lost) +
                                " triangles have no area or cross themselves, expected simple polygons");
}

/// The same cells in objects of their own: VTK's filters traverse cells by a position that the cell array itself holds,
/// so that solves in several threads must not share it. The numbers are shared.
vtkSmartPointer<vtkPolyData> WithOwnTraversal(vtkPolyData* surfaces)
{
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->ShallowCopy(surfaces);
  vtkNew<vtkCellArray> polygons, strips;
  polygons->ShallowCopy(surfaces->GetPolys());
  strips->ShallowCopy(surfaces->GetStrips());
  own->SetPolys(polygons);
  own->SetStrips(strips);
  return own;
}

void AddSurfaces(vtkPolyData* surfaces, kalos::SceneDescription& scene)
{
  vtkKalosArrayLengths::Require(surfaces->GetCellData(), surfaces->GetNumberOfCells(), "surface cells");
  const vtkSmartPointer<vtkPolyData> input = CutConcavePolygons(WithOwnTraversal(surfaces));
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(input);
  triangulate->PassLinesOff();
  triangulate->PassVertsOff();
  triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();
  RefuseLostPolygons(input, triangles);
  if (triangles->GetNumberOfCells() == 0)
    return;

  vtkDataArray* reflectance = triangles->GetCellData()->GetArray(Names::Reflectance);
  vtkDataArray* exitance = triangles->GetCellData()->GetArray(Names::Exitance);
  if (!reflectance)
    throw std::invalid_argument("surfaces: the cell array Reflectance is missing");
  scene.bands = CountBands(exitance, CountBands(reflectance, 1));

  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
    scene.points.push_back(ToVec3(triangles->GetPoint(i)));

  vtkDataArray* surfaceIds = triangles->GetCellData()->GetArray(Names::SurfaceId);
  auto* names = vtkStringArray::SafeDownCast(surfaces->GetFieldData()->GetAbstractArray(Names::SurfaceNames));
  for (vtkIdType i = 0; surfaceIds && names && i < names->GetNumberOfValues(); ++i)
    scene.surfaceNames.push_back(names->GetValue(i));

  // Cells of equal properties share a material.
  std::map<MaterialKey, std::uint32_t> known;
  auto cells = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    cells->GetCurrentCell(count, ids);
    const kalos::Material material = ReadMaterial(triangles->GetCellData(), cells->GetCurrentCellId(), scene.bands);
    const auto found = known.emplace(KeyOf(material), scene.materials.size());
    if (found.second)
      scene.materials.push_back(material);
    scene.triangles.push_back(
        {static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2])});
    scene.triangleMaterial.push_back(found.first->second);
    if (scene.surfaceNames.empty())
      continue;
    const double surface = surfaceIds->GetComponent(cells->GetCurrentCellId(), 0);
    if (surface >= 0 && surface < static_cast<double>(scene.surfaceNames.size()))
      scene.triangleSurface.push_back(static_cast<std::uint32_t>(surface));
    else  // what has no name is told apart by materials, and all of it
    {
      scene.surfaceNames.clear();
      scene.triangleSurface.clear();
    }
  }
}
}  // namespace

kalos::SceneDescription MakeSceneDescription(vtkDataObject* surfaces, vtkPolyData* luminaires)
{
  kalos::SceneDescription scene;
  AddSurfaces(JoinSurfaces(surfaces), scene);
  if (luminaires)
    AddLuminaires(luminaires, scene);
  scene.sky = MakeSky(luminaires);
  if (scene.triangles.empty() && scene.luminaires.empty() && !scene.sky)
    throw std::invalid_argument("surfaces: no triangles and no luminaires, there is nothing to estimate");
  return scene;
}
