// SPDX-License-Identifier: BSD-3-Clause
#include "SceneConversion.h"

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

#include "ConcavePolygons.h"
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

constexpr double largestDistribution = 1e6;  // luminaires may have as many candela tables

[[noreturn]] void Refuse(const char* array, const char* what, vtkIdType i, const std::string& expected)
{
  throw std::invalid_argument(std::string(array) + " of " + what + " " + std::to_string(i) + ": " + expected);
}

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

kalos::Vec3 ToVec3(const double v[3])
{
  return {v[0], v[1], v[2]};
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
  for (int b = 0; b < bands; ++b)
    if (!(material.reflectance[b] + material.specular + material.mirror < 1))
      Refuse(Names::Reflectance, "cell", cell, "with Specular and Mirror must sum to less than 1");
  if (material.specular > 0 && !(material.roughness > 0))
    Refuse(Names::Roughness, "cell", cell, "is 0, expected a number in (0, 1]; use Mirror for a perfect mirror");
  return material;
}

using MaterialKey = std::tuple<kalos::Bands, kalos::Bands, double, double, double>;

MaterialKey KeyOf(const kalos::Material& m)
{
  return {m.reflectance, m.exitance, m.specular, m.roughness, m.mirror};
}

/// The triangulation leaves out polygons without area and those it can not cut; nothing is dropped silently.
void RefuseLostPolygons(vtkPolyData* input, vtkPolyData* triangles)
{
  vtkIdType expected = input->GetPolys()->GetNumberOfConnectivityIds() - 2 * input->GetNumberOfPolys();
  expected += input->GetStrips()->GetNumberOfConnectivityIds() - 2 * input->GetNumberOfStrips();
  const vtkIdType lost = expected - triangles->GetNumberOfPolys();
  if (lost > 0)
    throw std::invalid_argument("surfaces: polygons worth " + std::to_string(lost) +
                                " triangles have no area or cross themselves, expected simple polygons");
}

void AddSurfaces(vtkPolyData* surfaces, kalos::SceneDescription& scene)
{
  vtkKalosArrayLengths::Require(surfaces->GetCellData(), surfaces->GetNumberOfCells(), "surface cells");
  const vtkSmartPointer<vtkPolyData> input = CutConcavePolygons(surfaces);
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

kalos::Vec3 ReadVector(vtkPolyData* luminaires, const char* name, vtkIdType i, const kalos::Vec3& absent)
{
  vtkDataArray* array = luminaires->GetPointData()->GetArray(name);
  if (!array)
    return absent;
  if (array->GetNumberOfComponents() != 3)
    throw std::invalid_argument(std::string(name) + ": has " + std::to_string(array->GetNumberOfComponents()) +
                                " components, expected 3");
  const kalos::Vec3 v = ToVec3(array->GetTuple3(i));
  if (!kalos::isFinite(v))
    Refuse(name, "luminaire", i, "must be finite");
  return v;
}

/// Table k of the field data; see vtkKalosArrayNames::CandelaTable.
std::shared_ptr<const kalos::CandelaTable> ReadTable(vtkPolyData* luminaires, int k)
{
  const std::string name = Names::CandelaTable + std::to_string(k);
  vtkDataArray* tuples = luminaires->GetFieldData()->GetArray(name.c_str());
  if (!tuples || tuples->GetNumberOfComponents() != 3)
    throw std::invalid_argument(name + ": the field data array is missing, expected tuples of plane, angle, candela");
  vtkDataArray* poles = luminaires->GetFieldData()->GetArray(Names::CandelaPoles);
  const bool side = poles && poles->GetNumberOfTuples() > k && poles->GetComponent(k, 0) != 0;
  std::vector<double> planes, angles, candela;
  bool inOrder = true;
  for (vtkIdType i = 0; i < tuples->GetNumberOfTuples(); ++i)
  {
    const double plane = tuples->GetComponent(i, 0), angle = tuples->GetComponent(i, 1);
    if (planes.empty() || plane != planes.back())
    {
      inOrder = inOrder && (planes.empty() || plane > planes.back()) && std::isfinite(plane);
      planes.push_back(plane);
    }
    if (planes.size() == 1)
    {
      inOrder = inOrder && (angles.empty() ? angle >= 0 : angle > angles.back()) && angle <= 180;
      angles.push_back(angle);
    }
    candela.push_back(tuples->GetComponent(i, 2));
    inOrder = inOrder && angle == angles[(candela.size() - 1) % angles.size()];
    if (!(candela.back() >= 0 && std::isfinite(candela.back())))
      Refuse(name.c_str(), "tuple", i, "is " + std::to_string(candela.back()) + " cd, expected 0 or more");
  }
  if (!inOrder || planes.size() < 2 || angles.size() < 2 || candela.size() != planes.size() * angles.size() ||
      planes.back() - planes.front() > 360)
    throw std::invalid_argument(name + ": expected ascending planes of up to 360 deg, and in each the same ascending " +
                                "angles from 0 to 180 deg");
  auto table = std::make_shared<kalos::CandelaTable>(
      planes, angles, candela, side ? kalos::CandelaTable::Pole::Side : kalos::CandelaTable::Pole::Axis);
  if (!(table->flux() > 0))
    throw std::invalid_argument(name + ": every intensity is 0, expected a luminaire that shines");
  return table;
}

/// Unit vector across the axis; without an array, any.
kalos::Vec3 ReadUp(vtkPolyData* luminaires, vtkIdType i, const kalos::Vec3& axis)
{
  const kalos::Vec3 given = ReadVector(luminaires, Names::Up, i, kalos::Frame(axis).s);
  const kalos::Vec3 across = given - kalos::dot(given, axis) * axis;
  if (!(kalos::length(across) > 1e-6 * kalos::length(given)))
    Refuse(Names::Up, "luminaire", i, "is along Direction, expected a direction across it");
  return kalos::normalized(across);
}

/// Without the zeros of a whole number.
std::string Shown(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

void AddLuminaires(vtkPolyData* input, kalos::SceneDescription& scene)
{
  std::map<int, std::shared_ptr<const kalos::CandelaTable>> tables;
  if (input->GetNumberOfPoints() == 0)
    return;
  vtkKalosArrayLengths::Require(input->GetPointData(), input->GetNumberOfPoints(), "luminaires");
  vtkDataArray* flux = input->GetPointData()->GetArray(Names::LuminousFlux);
  vtkDataArray* distribution = input->GetPointData()->GetArray(Names::Distribution);
  if (!flux)
    throw std::invalid_argument("luminaires: the point array LuminousFlux is missing");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    kalos::Luminaire l;
    l.position = ToVec3(input->GetPoint(i));
    l.flux = flux->GetComponent(i, 0);
    if (!kalos::isFinite(l.position))
      Refuse("position", "luminaire", i, "must be finite");
    if (!(l.flux >= 0 && std::isfinite(l.flux)))
      Refuse(Names::LuminousFlux, "luminaire", i, "is " + std::to_string(l.flux) + ", expected lumens >= 0");
    const kalos::Vec3 axis = ReadVector(input, Names::Direction, i, {0, 0, -1});
    if (!(kalos::length(axis) > 0))
      Refuse(Names::Direction, "luminaire", i, "must not be zero");
    l.axis = kalos::normalized(axis);
    l.sideU = ReadVector(input, Names::SideU, i, {});
    l.sideV = ReadVector(input, Names::SideV, i, {});
    if (!l.isPoint() && !(kalos::length(kalos::cross(l.sideU, l.sideV)) > 0))
      Refuse(Names::SideV, "luminaire", i, "spans no area with SideU");
    const double number = distribution ? distribution->GetComponent(i, 0) : 1;
    if (!(number >= 0 && number <= largestDistribution && number == std::floor(number)))
      Refuse(Names::Distribution, "luminaire", i,
             "is " + Shown(number) + ", expected 0 (isotropic), 1 (Lambertian) or 2 and more (candela tables)");
    const int kind = static_cast<int>(number);
    l.distribution = kind == 0 && l.isPoint() ? kalos::Distribution::Isotropic : kalos::Distribution::Lambertian;
    if (kind >= 2)
    {
      l.distribution = kalos::Distribution::Measured;
      l.up = ReadUp(input, i, l.axis);
      auto& table = tables[kind - 2];
      if (!table)
        table = ReadTable(input, kind - 2);
      l.table = table;
    }
    scene.luminaires.push_back(l);
  }
}
}  // namespace

kalos::SceneDescription MakeSceneDescription(vtkPolyData* surfaces, vtkPolyData* luminaires)
{
  kalos::SceneDescription scene;
  AddSurfaces(surfaces, scene);
  if (luminaires)
    AddLuminaires(luminaires, scene);
  if (scene.triangles.empty() && scene.luminaires.empty())
    throw std::invalid_argument("surfaces: no triangles and no luminaires, there is nothing to estimate");
  return scene;
}
