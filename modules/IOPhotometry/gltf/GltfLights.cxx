// SPDX-License-Identifier: BSD-3-Clause
#include "GltfLights.h"

#include <algorithm>
#include <cmath>

#include "../material/MetallicRoughness.h"

namespace kalos::scene
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int LongerSide = 512;  ///< pixels of a camera: the file gives none
constexpr double UsualAspect = 4.0 / 3.0;

Vector3 UnitDirection(const JsonCursor& node, const Vector3& direction)
{
  const double length = norm(direction);
  if (!(length > 0.0 && std::isfinite(length)))
  {
    node.Fail("a light or camera whose transform leaves it no direction; expected a scale that is not 0");
  }
  return 1.0 / length * direction;
}

double Luminance(const JsonCursor& light)
{
  const auto color = light.Find("color");
  if (!color)
  {
    return 1.0;
  }
  const std::vector<double> rgb = color->Bands();
  if (rgb.size() != 3)
  {
    color->FailExpected("three numbers");
  }
  return LuminanceOf({rgb[0], rgb[1], rgb[2]});
}

void ReadCone(const JsonCursor& light, ModelLight& result)
{
  const auto spot = light.Find("spot");
  const auto inner = spot ? spot->Find("innerConeAngle") : std::nullopt;
  const auto outer = spot ? spot->Find("outerConeAngle") : std::nullopt;
  result.OuterAngle = outer ? outer->NumberAbove(0.0) : Pi / 4.0;
  result.InnerAngle = inner ? inner->NumberAtLeast(0.0) : 0.0;
  if (outer && !(result.OuterAngle <= Pi / 2.0 + 1e-6))
  {
    outer->FailExpected("an angle above 0 and at most pi/2");
  }
  if (inner && !(result.InnerAngle < result.OuterAngle))
  {
    inner->FailExpected("an angle below outerConeAngle");
  }
}

std::string NameOf(const JsonCursor& node, const JsonCursor& element, const std::string& kind)
{
  for (const JsonCursor& named : {node, element})
  {
    const auto name = named.Find("name");
    if (name && !name->String().empty())
    {
      return name->String();
    }
  }
  return kind;
}
}  // namespace

std::optional<ModelLight> ReadGltfLight(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                        NoteCounter& found)
{
  const auto extensions = node.Find("extensions");
  const auto holder = extensions ? extensions->Find("KHR_lights_punctual") : std::nullopt;
  if (!holder)
  {
    return {};
  }
  const JsonCursor number = holder->At("light");
  const std::vector<JsonCursor> lights = file.Root().At("extensions").At("KHR_lights_punctual").At("lights").Items();
  const std::size_t index = WholeNumber(number);
  if (index >= lights.size())
  {
    number.FailExpected("the number of one of " + std::to_string(lights.size()) + " lights, counted from 0");
  }
  const JsonCursor& light = lights[index];
  ModelLight result;
  result.Name = NameOf(node, light, "light");
  const auto intensity = light.Find("intensity");
  const double luminance = Luminance(light);
  result.Strength = luminance * (intensity ? intensity->NumberAtLeast(0.0) : 1.0);
  result.Position = world.Origin;
  result.Aim = UnitDirection(node, -1.0 * world.Axes[2]);
  const JsonCursor type = light.At("type");
  if (type.String() == "spot")
  {
    result.Type = ModelLight::Kind::Spot;
    ReadCone(light, result);
  }
  else if (type.String() == "directional")
  {
    result.Type = ModelLight::Kind::Parallel;
  }
  else if (type.String() != "point")
  {
    type.FailExpected("\"point\", \"spot\" or \"directional\"");
  }
  if (luminance != 1.0)
  {
    found.Count("coloured lights", result.Name, "white", "luminaires are neutral: the luminance of the colour counts");
  }
  if (light.Has("range"))
  {
    found.Count("ranges of lights", result.Name, "without end", "light ends at surfaces only");
  }
  return result;
}

std::optional<Camera> ReadGltfCamera(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                     NoteCounter& found)
{
  const auto number = node.Find("camera");
  if (!number)
  {
    return {};
  }
  const JsonCursor& source = file.Element(*number, "cameras");
  const std::string name = NameOf(node, source, "camera");
  if (source.At("type").String() != "perspective")
  {
    found.Count("cameras", name, "left out", "only perspective is modelled");
    return {};
  }
  const JsonCursor lens = source.At("perspective");
  const JsonCursor angle = lens.At("yfov");
  Camera camera;
  camera.Name = name;
  camera.Position = world.Origin;
  camera.Target = world.Origin + UnitDirection(node, -1.0 * world.Axes[2]);
  camera.Up = UnitDirection(node, world.Axes[1]);
  camera.FieldOfView = angle.NumberAbove(0.0) * 180.0 / Pi;
  if (!(camera.FieldOfView < 180.0))
  {
    angle.FailExpected("an angle above 0 and below pi");
  }
  const auto ratio = lens.Find("aspectRatio");
  const double aspect = ratio ? ratio->NumberAbove(0.0) : UsualAspect;
  const double widest = std::max(1.0, aspect);
  camera.Resolution = {std::max(1, static_cast<int>(std::lround(LongerSide * aspect / widest))),
                       std::max(1, static_cast<int>(std::lround(LongerSide / widest)))};
  found.Count("cameras", name, "512 pixels along the longer side", "a glTF camera has no resolution");
  return camera;
}
}  // namespace kalos::scene
