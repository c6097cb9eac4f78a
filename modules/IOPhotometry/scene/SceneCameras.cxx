// SPDX-License-Identifier: BSD-3-Clause
#include "SceneCameras.h"

#include "../mesh/Mesh.h"

namespace kalos::scene
{
namespace
{
Camera ReadCamera(const JsonCursor& node)
{
  node.CheckKeys({"name", "position", "target", "up", "fov_deg", "resolution"});
  Camera camera;
  camera.Name = node.Name();
  static_cast<Sight&>(camera) = ReadSight(node);
  const JsonCursor angle = node.At("fov_deg");
  camera.FieldOfView = angle.Number();
  if (!(camera.FieldOfView > 0.0 && camera.FieldOfView < 180.0))
  {
    angle.FailExpected("an angle above 0 and below 180 degrees");
  }
  camera.Resolution = node.At("resolution").Resolution();
  return camera;
}
}  // namespace

Sight ReadSight(const JsonCursor& node)
{
  Sight sight;
  sight.Position = node.At("position").Vector();
  sight.Target = node.At("target").Vector();
  const Vector3 view = sight.Target - sight.Position;
  if (norm(view) == 0.0)
  {
    node.At("target").Fail("the target is the position; expected another point");
  }
  if (const auto up = node.Find("up"))
  {
    sight.Up = up->NonZeroVector();
  }
  if (!(norm(cross(view, sight.Up)) > 1e-9 * norm(view) * norm(sight.Up)))
  {
    node.Fail("\"up\" ([0, 0, 1] if absent) is parallel to the view; expected another direction");
  }
  return sight;
}

std::vector<Camera> ReadCameras(const JsonCursor& scene, std::set<std::string>& names)
{
  std::vector<Camera> cameras;
  const auto section = scene.Find("cameras");
  for (const JsonCursor& node : section ? section->Items() : std::vector<JsonCursor>())
  {
    cameras.push_back(ReadCamera(node));
    if (!names.insert(cameras.back().Name).second)
    {
      node.Fail("another receiver or camera has this name; expected a name of its own, as results are named after it");
    }
  }
  return cameras;
}
}  // namespace kalos::scene
