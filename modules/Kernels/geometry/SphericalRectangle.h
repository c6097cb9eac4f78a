// SPDX-License-Identifier: BSD-3-Clause
// A rectangle seen from a point: its solid angle, and points uniform in it (Urena, Fajardo, King 2013).
#ifndef kalos_geometry_SphericalRectangle_h
#define kalos_geometry_SphericalRectangle_h

#include "geometry/Vector.h"

namespace kalos
{
class SphericalRectangle
{
public:
  /// `u` and `v` are perpendicular sides. The point must not lie in the rectangle's plane.
  SphericalRectangle(const Vec3& from, const Vec3& corner, const Vec3& u, const Vec3& v);

  double solidAngle() const { return this->Omega; }  ///< sr

  /// A point of the rectangle whose direction is uniform in the solid angle, for u1, u2 in [0,1).
  Vec3 sample(double u1, double u2) const;

private:
  Vec3 From, X, Y, Z;
  double X0, X1, Y0, Y1, Z0;
  double B0, B1, K, Omega;
};
}  // namespace kalos

#endif
