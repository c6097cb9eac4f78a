// SPDX-License-Identifier: BSD-3-Clause
#include "SkyConversion.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sky/Sky.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosSkySource.h"
#include "vtkPolyData.h"

namespace
{
namespace Names = vtkKalosArrayNames;
using Source = vtkKalosSkySource;

kalos::SkyMap ReadMap(vtkPolyData* luminaires)
{
  vtkDataArray* rows = luminaires->GetFieldData()->GetArray(Names::SkyMap);
  if (!rows)
    throw std::invalid_argument("SkyMap: the field data array is missing, expected the rows of a picture");
  kalos::SkyMap map;
  map.width = rows->GetNumberOfComponents();
  map.height = static_cast<int>(rows->GetNumberOfTuples());
  for (vtkIdType i = 0; i < rows->GetNumberOfTuples(); ++i)
    for (int j = 0; j < map.width; ++j)
    {
      const double value = rows->GetComponent(i, j);
      if (!(value >= 0 && std::isfinite(value)))
        throw std::invalid_argument("SkyMap: row " + std::to_string(i) + ", column " + std::to_string(j) + " is " +
                                    std::to_string(value) + ", expected cd/m2, 0 or more");
      map.luminance.push_back(static_cast<float>(value));
    }
  return map;
}

/// The unit vector of an elevation and an azimuth clockwise from north, which is +y turned clockwise.
kalos::Vec3 Towards(double elevation, double azimuth, double north)
{
  constexpr double degree = kalos::pi / 180;
  const double turn = (azimuth + north) * degree, across = std::cos(elevation * degree);
  return kalos::normalized({across * std::sin(turn), across * std::cos(turn), std::sin(elevation * degree)});
}
}  // namespace

std::shared_ptr<const kalos::Sky> MakeSky(vtkPolyData* luminaires)
{
  vtkDataArray* array = luminaires ? luminaires->GetFieldData()->GetArray(Names::Sky) : nullptr;
  if (!array)
    return nullptr;
  if (array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != Source::NUMBER_OF_COMPONENTS)
    throw std::invalid_argument("Sky: is no array of vtkKalosSkySource, expected one tuple of " +
                                std::to_string(static_cast<int>(Source::NUMBER_OF_COMPONENTS)) + " components");
  std::array<double, Source::NUMBER_OF_COMPONENTS> v;
  array->GetTuple(0, v.data());
  const int model = static_cast<int>(v[Source::MODEL]);
  kalos::SkyDescription sky;
  sky.horizontalIlluminance = v[Source::HORIZONTAL_ILLUMINANCE];
  sky.zenithLuminance = v[Source::ZENITH_LUMINANCE];
  sky.sun = Towards(v[Source::SUN_ELEVATION], v[Source::SUN_AZIMUTH], v[Source::NORTH]);
  sky.sunIlluminance = std::max(0.0, v[Source::SUN_ILLUMINANCE]);
  sky.groundReflectance = v[Source::GROUND_REFLECTANCE];
  if (model == Source::PEREZ)
  {
    const kalos::PerezSky perez =
        kalos::perezSky({v[Source::DIRECT_IRRADIANCE], v[Source::DIFFUSE_IRRADIANCE],
                         std::min(std::acos(std::min(1.0, sky.sun.z)), 0.5 * kalos::pi - 1e-6)});
    sky.pattern = kalos::makeSky(perez.coefficients, sky.sun);
    if (sky.horizontalIlluminance < 0 && sky.zenithLuminance < 0)
      sky.horizontalIlluminance = perez.diffuseIlluminance;
    if (v[Source::SUN_ILLUMINANCE] < 0)
      sky.sunIlluminance = perez.directNormalIlluminance;
  }
  else if (model == Source::MAP)
    sky.pattern = kalos::makeSky(ReadMap(luminaires), Towards(0, 0, v[Source::NORTH]));
  else
    sky.pattern = model == 16 ? kalos::makeTraditionalOvercast() : kalos::makeSky(kalos::cieSky(model), sky.sun);
  return std::make_shared<const kalos::Sky>(sky);
}
