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

Vector3 unitDirection(const JsonCursor& node, const Vector3& direction)
{
  const double length = norm(direction);
  if (!(length > 0.0 && std::isfinite(length)))
  {
    node.fail("a light or camera whose transform leaves it no direction; expected a scale that is not 0");
  }
  return 1.0 / length * direction;
}

double colorLuminance(const JsonCursor& light)
{
  const auto color = light.find("color");
  if (!color)
  {
    return 1.0;
  }
  const std::vector<double> rgb = color->bands();
  if (rgb.size() != 3)
  {
    color->failExpected("three numbers");
  }
  return luminanceOf({rgb[0], rgb[1], rgb[2]});
}

void readCone(const JsonCursor& light, ModelLight& result)
{
  const auto spot = light.find("spot");
  const auto inner = spot ? spot->find("innerConeAngle") : std::nullopt;
  const auto outer = spot ? spot->find("outerConeAngle") : std::nullopt;
  result.outerAngle = outer ? outer->numberAbove(0.0) : Pi / 4.0;
  result.innerAngle = inner ? inner->numberAtLeast(0.0) : 0.0;
  if (outer && !(result.outerAngle <= Pi / 2.0 + 1e-6))
  {
    outer->failExpected("an angle above 0 and at most pi/2");
  }
  if (inner && !(result.innerAngle <= result.outerAngle))
  {
    inner->failExpected("an angle of at most outerConeAngle");
  }
}

std::string nameOf(const JsonCursor& node, const JsonCursor& element, const std::string& kind)
{
  for (const JsonCursor& named : {node, element})
  {
    const auto name = named.find("name");
    if (name && !name->string().empty())
    {
      return name->string();
    }
  }
  return kind;
}
}  // namespace

std::optional<ModelLight> readGltfLight(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                        NoteCounter& found)
{
  const auto extensions = node.find("extensions");
  const auto holder = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
  if (!holder)
  {
    return {};
  }
  const JsonCursor number = holder->at("light");
  const std::vector<JsonCursor> lights = file.root().at("extensions").at("KHR_lights_punctual").at("lights").items();
  const std::size_t index = wholeNumber(number);
  if (index >= lights.size())
  {
    number.failExpected("the number of one of " + std::to_string(lights.size()) + " lights, counted from 0");
  }
  const JsonCursor& light = lights[index];
  ModelLight result;
  result.name = nameOf(node, light, "light");
  const auto intensity = light.find("intensity");
  const double luminance = colorLuminance(light);
  result.strength = luminance * (intensity ? intensity->numberAtLeast(0.0) : 1.0);
  result.position = world.origin;
  result.aim = unitDirection(node, -1.0 * world.axes[2]);
  const JsonCursor type = light.at("type");
  if (type.string() == "spot")
  {
    result.type = ModelLight::Kind::Spot;
    readCone(light, result);
  }
  else if (type.string() == "directional")
  {
    result.type = ModelLight::Kind::Parallel;
  }
  else if (type.string() != "point")
  {
    type.failExpected("\"point\", \"spot\" or \"directional\"");
  }
  if (luminance != 1.0)
  {
    found.count("coloured lights", result.name, "white", "luminaires are neutral: the luminance of the colour counts");
  }
  if (light.has("range"))
  {
    found.count("ranges of lights", result.name, "without end", "light ends at surfaces only");
  }
  return result;
}

std::optional<Camera> readGltfCamera(const GltfFile& file, const JsonCursor& node, const Transform& world,
                                     NoteCounter& found)
{
  const auto number = node.find("camera");
  if (!number)
  {
    return {};
  }
  const JsonCursor& source = file.element(*number, "cameras");
  const std::string name = nameOf(node, source, "camera");
  if (source.at("type").string() != "perspective")
  {
    found.count("cameras", name, "left out", "only perspective is modelled");
    return {};
  }
  const JsonCursor lens = source.at("perspective");
  const JsonCursor angle = lens.at("yfov");
  Camera camera;
  camera.name = name;
  camera.position = world.origin;
  camera.target = world.origin + unitDirection(node, -1.0 * world.axes[2]);
  camera.up = unitDirection(node, world.axes[1]);
  camera.fieldOfView = angle.numberAbove(0.0) * 180.0 / Pi;
  if (!(camera.fieldOfView < 180.0))
  {
    angle.failExpected("an angle above 0 and below pi");
  }
  const auto ratio = lens.find("aspectRatio");
  const double aspect = ratio ? ratio->numberAbove(0.0) : UsualAspect;
  const double widest = std::max(1.0, aspect);
  camera.resolution = {std::max(1, static_cast<int>(std::lround(LongerSide * aspect / widest))),
                       std::max(1, static_cast<int>(std::lround(LongerSide / widest)))};
  found.count("cameras", name, "512 pixels along the longer side", "a glTF camera has no resolution");
  return camera;
}
}  // namespace kalos::scene
