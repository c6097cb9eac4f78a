// SPDX-License-Identifier: BSD-3-Clause
// Rays from anywhere to anywhere, together: sixteen at a time in single precision where that decides as well, one by
// one in double precision where it does not.
//
// In a furnished room of 36 triangles, rays without any order: first hits 130 to 160 ns each (300 to 360 alone), shadow
// rays 115 to 125 ns (390 to 590 alone).
#ifndef kalos_scene_RayBatch_h
#define kalos_scene_RayBatch_h

#include "scene/Scene.h"

namespace kalos
{
/// Whether something `distance` away is seen from the start of a ray, or sees it, as from a point lifted off its
/// surface: then single precision serves. What lies nearer decides in double precision.
bool isFarFrom(const RayAnchor& start, double squaredDistance);

/// The squared distance, m2, from which on it is.
double squaredNearness(const RayAnchor& start);

/// Whether a surface point that a ray from `start` has met is crowded by the surface that the ray left.
bool crowds(const RayAnchor& start, double squaredDistance);

/// Whether a surface faces the anchor so near that all its rays must be traced alone: the point lifted off its own
/// surface might lie beyond the other.
bool isInGap(const Scene& scene, const RayAnchor& anchor);

struct PathRay
{
  RayAnchor start;
  Vec3 direction;        ///< unit
  bool doublePrecision;  ///< in double precision, whatever it meets
  SurfacePoint end;
};

/// Finds where each of the rays ends, as Scene::trace() does.
void traceTogether(const Scene& scene, std::vector<PathRay>& rays);

struct ShadowRay
{
  RayAnchor from, to;
  bool doublePrecision;
  bool hidden = false;
};

/// Finds which of the rays are hidden, as RayScene::occluded() does.
void shadowTogether(const RayScene& scene, std::vector<ShadowRay>& rays);
}  // namespace kalos

#endif
