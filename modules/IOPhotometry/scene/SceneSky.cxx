// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSky.h"

#include "../base/ErrorCatcher.h"
#include "../base/InputError.h"
#include "../image/SkyPicture.h"
#include "vtkKalosSkySource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace kalos::scene
{
namespace
{
/** Types whose luminance depends on the sun's place. */
bool needsSun(int cie)
{
  return cie == 2 || cie == 4 || (cie >= 6 && cie <= 15);
}

void readSun(const JsonCursor& sun, vtkKalosSkySource* source)
{
  sun.checkKeys({"elevation_deg", "azimuth_deg", "normal_illuminance"});
  const JsonCursor elevation = sun.at("elevation_deg");
  if (elevation.number() < 0.0)
  {
    elevation.failExpected("0 to 90 degrees: the sun is below the horizon");
  }
  if (elevation.number() > 90.0)
  {
    elevation.failExpected("0 to 90 degrees");
  }
  source->SetSunElevationDegrees(elevation.number());
  source->SetSunAzimuthDegrees(sun.at("azimuth_deg").number());
  if (const auto illuminance = sun.find("normal_illuminance"))
  {
    source->SetSunNormalIlluminance(illuminance->numberAtLeast(0.0));
  }
}

void readPerez(const JsonCursor& perez, vtkKalosSkySource* source)
{
  perez.checkKeys({"direct_normal_irradiance", "diffuse_horizontal_irradiance"});
  source->SetModel(vtkKalosSkySource::PEREZ);
  source->SetDirectNormalIrradiance(perez.at("direct_normal_irradiance").numberAtLeast(0.0));
  source->SetDiffuseHorizontalIrradiance(perez.at("diffuse_horizontal_irradiance").numberAtLeast(0.0));
  source->SetSunNormalIlluminance(-1.0);  // of the model, if the sun does not say
}

/** What the sky looks like: exactly one of `cie`, `perez`, `map`. */
void readModel(const JsonCursor& sky, const std::string& folder, vtkKalosSkySource* source, Notes& notes)
{
  const int models = sky.has("cie") + sky.has("perez") + sky.has("map");
  if (models != 1)
  {
    sky.fail(std::to_string(models) + " of \"cie\", \"perez\" and \"map\" found; expected one of them");
  }
  if (const auto cie = sky.find("cie"))
  {
    source->SetModel(cie->integer(1, 16));
  }
  if (const auto perez = sky.find("perez"))
  {
    readPerez(*perez, source);
  }
  if (const auto map = sky.find("map"))
  {
    source->SetModel(vtkKalosSkySource::MAP);
    try
    {
      source->SetMap(kalos::readSkyPicture(resolvePath(folder, map->string(), notes)));
    }
    catch (const std::exception& error)
    {
      map->fail(error.what());
    }
  }
  const bool byModel =
      source->GetModel() == vtkKalosSkySource::PEREZ || (source->GetModel() > 0 && needsSun(source->GetModel()));
  if (byModel && !sky.has("sun"))
  {
    sky.fail("no \"sun\"; expected one, this sky is brightest about it");
  }
}

void readBrightness(const JsonCursor& sky, vtkKalosSkySource* source)
{
  const auto horizontal = sky.find("horizontal_illuminance"), zenith = sky.find("zenith_luminance");
  if (horizontal && zenith)
  {
    sky.fail("both \"horizontal_illuminance\" and \"zenith_luminance\"; expected one of them");
  }
  if (!horizontal && !zenith && source->GetModel() > 0)
  {
    sky.fail("no \"horizontal_illuminance\"; expected it, or \"zenith_luminance\"");
  }
  source->SetHorizontalIlluminance(horizontal ? horizontal->numberAtLeast(0.0) : -1.0);
  source->SetZenithLuminance(zenith ? zenith->numberAtLeast(0.0) : -1.0);
}
}  // namespace

vtkSmartPointer<vtkPolyData> addSky(const JsonCursor& scene, const std::string& folder, vtkPolyData* luminaires,
                                    Notes& notes)
{
  const auto sky = scene.find("sky");
  if (!sky)
  {
    for (const char* key : {"north_deg", "ground"})
    {
      if (const auto alone = scene.find(key))
      {
        alone->fail("there is no \"sky\"; expected one with it");
      }
    }
    return luminaires;
  }
  vtkNew<vtkKalosSkySource> source;
  sky->checkKeys({"cie", "perez", "map", "horizontal_illuminance", "zenith_luminance", "sun"});
  readModel(*sky, folder, source, notes);
  readBrightness(*sky, source);
  if (const auto sun = sky->find("sun"))
  {
    readSun(*sun, source);
  }
  if (const auto north = scene.find("north_deg"))
  {
    source->SetNorthDegrees(north->number());
  }
  if (const auto ground = scene.find("ground"))
  {
    ground->checkKeys({"reflectance"});
    source->SetGroundReflectance(ground->at("reflectance").fraction());
  }
  source->SetInputData(luminaires);
  const ErrorCatcher errors(source);
  source->Update();
  if (!errors.empty())
  {
    sky->fail(errors.firstLine());
  }
  return source->GetOutput();
}
}  // namespace kalos::scene
