// SPDX-License-Identifier: BSD-3-Clause
/** The "cameras" of a scene file. */
#ifndef KalosSceneCameras_h
#define KalosSceneCameras_h

#include <array>
#include <set>
#include <string>
#include <vector>

#include "SceneJson.h"

namespace kalos::scene
{
struct Sight
{
  Vector3 Position{};         ///< m
  Vector3 Target{};           ///< m
  Vector3 Up{0.0, 0.0, 1.0};  ///< any length
};

/** The keys position, target and up of a camera or an observer. */
Sight ReadSight(const Node& node);

struct Camera : Sight
{
  std::string Name;
  double FieldOfView = 45.0;        ///< vertical, degrees
  std::array<int, 2> Resolution{};  ///< pixels, width and height
};

/** Read the array "cameras"; `names` as for the receivers. */
std::vector<Camera> ReadCameras(const Node& scene, std::set<std::string>& names);
}  // namespace kalos::scene

#endif
