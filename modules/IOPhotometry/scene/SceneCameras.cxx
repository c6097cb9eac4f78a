// SPDX-License-Identifier: BSD-3-Clause
#include "SceneCameras.h"

#include "../mesh/Mesh.h"

namespace kalos::scene
{
namespace
{
Camera readCamera(const JsonCursor& node)
{
  node.checkKeys({"name", "position", "target", "up", "fov_deg", "resolution"});
  Camera camera;
  camera.name = node.name();
  static_cast<Sight&>(camera) = readSight(node);
  const JsonCursor angle = node.at("fov_deg");
  camera.fieldOfView = angle.number();
  if (!(camera.fieldOfView > 0.0 && camera.fieldOfView < 180.0))
  {
    angle.failExpected("an angle above 0 and below 180 degrees");
  }
  camera.resolution = node.at("resolution").resolution();
  return camera;
}
}  // namespace

Sight readSight(const JsonCursor& node)
{
  Sight sight;
  sight.position = node.at("position").vector();
  sight.target = node.at("target").vector();
  const Vector3 view = sight.target - sight.position;
  if (norm(view) == 0.0)
  {
    node.at("target").fail("the target is the position; expected another point");
  }
  if (const auto up = node.find("up"))
  {
    sight.up = up->nonZeroVector();
  }
  if (!(norm(cross(view, sight.up)) > 1e-9 * norm(view) * norm(sight.up)))
  {
    node.fail("\"up\" ([0, 0, 1] if absent) is parallel to the view; expected another direction");
  }
  return sight;
}

std::vector<Camera> readCameras(const JsonCursor& scene, std::set<std::string>& names)
{
  std::vector<Camera> cameras;
  const auto section = scene.find("cameras");
  for (const JsonCursor& node : section ? section->items() : std::vector<JsonCursor>())
  {
    cameras.push_back(readCamera(node));
    if (!names.insert(cameras.back().name).second)
    {
      node.fail("another receiver or camera has this name; expected a name of its own, as results are named after it");
    }
  }
  return cameras;
}
}  // namespace kalos::scene
