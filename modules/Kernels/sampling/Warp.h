// SPDX-License-Identifier: BSD-3-Clause
// Maps from the unit square to directions and surfaces; each comment states the density it produces.
#ifndef kalos_sampling_Warp_h
#define kalos_sampling_Warp_h

#include "geometry/Vector.h"

namespace kalos
{
/// Uniform on the unit sphere: density 1/(4 pi) per sr.
inline Vec3 uniformSphere(double u1, double u2)
{
  const double z = 1 - 2 * u1, s = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * pi * u2;
  return {s * std::cos(phi), s * std::sin(phi), z};
}

/// Cosine-weighted on the hemisphere about +z: density cos(theta)/pi per sr. Never exactly on the horizon.
inline Vec3 cosineHemisphere(double u1, double u2)
{
  const double s = std::sqrt(u1), phi = 2 * pi * u2;
  return {s * std::cos(phi), s * std::sin(phi), std::sqrt(1 - u1)};
}

/// Barycentric weights of the second and third corner, uniform on a triangle: density 1/area.
inline void uniformTriangle(double u1, double u2, double& b1, double& b2)
{
  const double root = std::sqrt(u1);
  b1 = root * (1 - u2);
  b2 = root * u2;
}
}  // namespace kalos

#endif
