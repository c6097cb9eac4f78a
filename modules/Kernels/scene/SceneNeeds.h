// SPDX-License-Identifier: BSD-3-Clause
// Checks before a solve which effects the scene needs.
#ifndef kalos_scene_SceneNeeds_h
#define kalos_scene_SceneNeeds_h

#include "scene/Scene.h"

namespace kalos
{
/// Emitting triangles whose direct light at receivers has a closed form; of more, vertices at the starts score.
constexpr std::uint32_t largestExact = 4096;

struct SceneNeeds
{
  /// No shadow ray is needed: every triangle lies on the boundary of the scene's convex hull, and all receivers and
  /// luminaires lie in the hull, so that nothing can stand between any two of them.
  bool unoccluded = false;
  std::uint32_t emittingTriangles = 0;
  bool reflects = false;  ///< some surface reflects
};

/// Whether some surface reflects.
bool reflects(const Scene& scene);

/// `receivers` in scene coordinates. Tests for a convex hull only where that takes well under a second.
SceneNeeds findNeeds(const Scene& scene, const std::vector<Vec3>& receivers);
}  // namespace kalos

#endif
