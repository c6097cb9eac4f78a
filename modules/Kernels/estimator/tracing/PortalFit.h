// SPDX-License-Identifier: BSD-3-Clause
// Where an opening is that many segments pass.
#ifndef kalos_estimator_tracing_PortalFit_h
#define kalos_estimator_tracing_PortalFit_h

#include "estimator/tracing/Portals.h"
#include "sampling/Random.h"
#include "scene/Scene.h"

namespace kalos
{
/// A free line of sight from a lit region into one that is not.
struct PortalSegment
{
  SurfacePoint lit, dark;
};

/// Finds the smallest rectangle, in the plane of a triangle beside the segments, that many of them pass, and takes
/// these away. False when there is none.
bool fitPortal(const Scene& scene, std::vector<PortalSegment>& segments, RandomStream& random, Portal& portal);

/// Narrows or widens it to where rays from points before it pass; false when fewer than `least` of the rays do.
bool correctPortal(const Scene& scene, const std::vector<Vec3>& from, double least, RandomStream& random,
                   Portal& portal);
}  // namespace kalos

#endif
