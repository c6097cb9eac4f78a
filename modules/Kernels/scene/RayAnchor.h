// SPDX-License-Identifier: BSD-3-Clause
// The ends of rays.
#ifndef kalos_scene_RayAnchor_h
#define kalos_scene_RayAnchor_h

#include "geometry/Vector.h"

namespace kalos
{
/// Where a ray starts or ends: at a point in free space, or at a point of a surface, whose own triangle it must not
/// meet. A single ray decides in double precision which triangles lie between its ends, so that it leaves a gap of any
/// width; but to triangles nearly parallel to the surface it reaches to lifted() only: models hold layers that nearly
/// coincide. Rays in packets are in single precision: both ends are lifted by the error of single precision, which
/// depends on the coordinates of the surface and of *both* ends, see Scene::anchor().
struct RayAnchor
{
  Vec3 point;
  Vec3 normal;       ///< unit, off the surface; zero in free space
  double base = 0;   ///< m, lift for the coordinates of the surface
  double slope = 0;  ///< lift for each metre of the ends' coordinates along the normal
  /// Other surfaces are so near that single precision cannot tell on which side of them the anchor lies: single rays
  /// test these in double precision; packets must not be used.
  bool crowded = false;

  RayAnchor() = default;
  RayAnchor(const Vec3& p) : point(p) {}  // implicit: most ends are points in free space
  RayAnchor(const Vec3& p, const Vec3& n, double liftOfSurface, double liftPerMetre)
      : point(p), normal(n), base(liftOfSurface), slope(liftPerMetre)
  {
  }

  /// m, how far the end of a ray is lifted whose other end is q.
  double liftFor(const Vec3& q) const { return this->base + this->slope * absDot(this->normal, q); }
  Vec3 liftedFor(const Vec3& q) const { return this->point + this->liftFor(q) * this->normal; }

  /// The same for a ray that starts here and ends anywhere.
  double lift() const { return this->liftFor(this->point); }
  Vec3 lifted() const { return this->liftedFor(this->point); }
};
}  // namespace kalos

#endif
