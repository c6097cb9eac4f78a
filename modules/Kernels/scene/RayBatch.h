// SPDX-License-Identifier: BSD-3-Clause
// Batches of arbitrary rays: packets of sixteen in single precision where that is accurate enough, single rays in
// double precision elsewhere.
//
// In a furnished room of 36 triangles, rays without any order: first hits take 130 to 160 ns each (300 to 360 as single
// rays), shadow rays 115 to 125 ns (390 to 590).
#ifndef kalos_scene_RayBatch_h
#define kalos_scene_RayBatch_h

#include "scene/Scene.h"

namespace kalos
{
/// Whether a point at this distance is so far from the start of a ray that single precision suffices, with the start
/// lifted off its surface. Nearer points need double precision.
bool isFarFrom(const RayAnchor& start, double squaredDistance);

/// The smallest squared distance, m2, for which isFarFrom() holds.
double squaredNearness(const RayAnchor& start);

/// Whether a surface point that a ray from `start` has met is crowded by the surface that the ray left.
bool crowds(const RayAnchor& start, double squaredDistance);

/// Whether a surface faces the anchor so near that all its rays need double precision: the point lifted off its own
/// surface might lie beyond the other.
bool isInGap(const Scene& scene, const RayAnchor& anchor);

struct PathRay
{
  RayAnchor start;
  Vec3 direction;        ///< unit
  bool doublePrecision;  ///< trace singly in double precision, whatever the distance
  SurfacePoint end;
};

/// Finds where each of the rays ends, as Scene::trace() does.
void traceTogether(const Scene& scene, std::vector<PathRay>& rays);

struct ShadowRay
{
  RayAnchor from, to;
  bool doublePrecision;
  bool hidden = false;
  double transmittance = 1;  ///< of the glass between, where it is not hidden
};

/// Finds which of the rays are hidden, as RayScene::occluded() does.
void shadowTogether(const RayScene& scene, std::vector<ShadowRay>& rays);
}  // namespace kalos

#endif
