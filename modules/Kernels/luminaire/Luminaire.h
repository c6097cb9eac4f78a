// SPDX-License-Identifier: BSD-3-Clause
// Luminaires: points with an intensity distribution, and luminous rectangles. They emit but have no body.
#ifndef kalos_luminaire_Luminaire_h
#define kalos_luminaire_Luminaire_h

#include "geometry/Vector.h"

namespace kalos
{
enum class Distribution
{
  Isotropic,  ///< I = flux / (4 pi)
  Lambertian  ///< I = flux cos(theta) / pi on the side of the axis
};

struct Luminaire
{
  Vec3 position;        ///< m; the centre of a rectangle
  Vec3 axis{0, 0, -1};  ///< unit vector of the photometric axis
  double flux = 0;      ///< lm, >= 0, neutral in all bands
  Distribution distribution = Distribution::Lambertian;
  Vec3 sideU, sideV;  ///< full sides of a luminous rectangle, m; both zero for a point

  bool isPoint() const { return this->sideU.x == 0 && this->sideU.y == 0 && this->sideU.z == 0; }
};

/// Luminous intensity of a point luminaire into the unit direction, cd.
double intensity(const Luminaire& luminaire, const Vec3& direction);

/// A unit direction drawn in proportion to the intensity, for u1, u2 in [0,1): every sample carries the flux.
Vec3 sampleDirection(const Luminaire& luminaire, double u1, double u2);
}  // namespace kalos

#endif
