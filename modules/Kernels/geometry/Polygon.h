// SPDX-License-Identifier: BSD-3-Clause
// Closed form of the light a Lambertian polygon sends to an element of surface, and sampling of its solid angle.
#ifndef kalos_geometry_Polygon_h
#define kalos_geometry_Polygon_h

#include "geometry/Vector.h"

namespace kalos
{
/// Form factor from the surface element at r with unit normal n to a planar convex polygon of `count` >= 3
/// corners: E = M F for a polygon of exitance M. The part below the horizon of r is cut away.
/// Lambert's formula: F = |sum of angle_i n.(unit normal of the plane r, c_i, c_i+1)| / 2 pi. Range [0, 1].
/// The side of the polygon that r lies on does not matter; a caller with one-sided emission checks it.
double polygonFormFactor(const Vec3& r, const Vec3& n, const Vec3* corners, int count);

/// The point of a planar convex polygon that is nearest to p.
Vec3 nearestPoint(const Vec3* corners, int count, const Vec3& p);

/// A triangle seen from a point: its solid angle and uniform samples of directions in it (Arvo 1995).
class SphericalTriangle
{
public:
  SphericalTriangle() = default;  ///< an empty one
  SphericalTriangle(const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c);

  /// Solid angle, sr. 0 when the triangle is seen edge on.
  double solidAngle() const { return this->Omega; }

  /// Unit direction, uniform in solid angle, for u1, u2 in [0,1). Only when solidAngle() > 0.
  Vec3 sample(double u1, double u2) const;

private:
  Vec3 A, B, C;                 // unit vectors to the corners
  double Alpha = 0, Omega = 0;  // angle at A, solid angle
  double CosAlpha = 0, SinAlpha = 0, CosC = 0;
};
}  // namespace kalos

#endif
