// SPDX-License-Identifier: BSD-3-Clause
// Places receivers on the right side of the surfaces that they touch.
#ifndef kalos_scene_Placement_h
#define kalos_scene_Placement_h

#include "scene/Scene.h"

namespace kalos
{
/// Places a receiver that was given at p with unit normal n, in the scene's coordinates.
///
/// A receiver that lies on a surface across its normal to within the rounding of its coordinates (on an edge, in a
/// corner, at the foot of an object) belongs to the side where its own surface is; where that is on both sides, or
/// where it lies on none, to the front. It is moved there, by a few micrometres in a room, but less than half the way
/// to the next surface. A receiver that lies clearly on one side, by more than a sixteenth of that rounding, is not
/// moved. RayAnchor::crowded says whether a surface is so near that single precision might put the receiver on its
/// other side.
RayAnchor placeReceiver(const Scene& scene, const Vec3& p, const Vec3& n);
}  // namespace kalos

#endif
