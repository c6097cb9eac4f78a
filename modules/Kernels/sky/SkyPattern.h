// SPDX-License-Identifier: BSD-3-Clause
// How luminance is distributed over the sky, up to a factor: CIE S 011 (ISO 15469), Perez's all-weather model, a map.
#ifndef kalos_sky_SkyPattern_h
#define kalos_sky_SkyPattern_h

#include <memory>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
/// Luminance of the sky relative to an arbitrary one; directions have z upwards, z > 0 is the sky.
class SkyPattern
{
public:
  virtual ~SkyPattern() = default;

  /// >= 0, for a unit direction with z >= 0.
  virtual double relative(const Vec3& direction) const = 0;

  /// Whether it is the same everywhere.
  virtual bool isUniform() const { return false; }
};

/// L ~ [1 + a exp(b / cos theta)] [base + c exp(d chi) + e cos^2 chi]: theta is the angle from the zenith, chi that
/// from the sun. The base of the CIE general sky is 1 - c exp(d pi/2), that of Perez's model 1.
struct SkyCoefficients
{
  double a = 0, b = -1, c = 0, d = -1, e = 0;
  double base = 1;
};

/// Of the CIE general sky of type 1 to 15; type 5 is uniform.
SkyCoefficients cieSky(int type);

/// The irradiances behind Perez's model, W/m2, and the sun's angle from the zenith, rad, below pi/2.
struct SkyIrradiance
{
  double directNormal = 0, diffuseHorizontal = 0;
  double sunZenithAngle = 0;
};

/// What Perez's models make of them; dew point 11 degrees C, mean distance of the sun.
struct PerezSky
{
  SkyCoefficients coefficients;
  double diffuseIlluminance = 0;       ///< lx on the horizontal, from the sky
  double directNormalIlluminance = 0;  ///< lx across the sun's rays
};

/// R. Perez et al. 1993 (all-weather luminance, with its erratum) and 1990 (luminous efficacies).
PerezSky perezSky(const SkyIrradiance& irradiance);

/// The formula above. `sun` is a unit vector; it does not matter where c and e are 0.
std::unique_ptr<SkyPattern> makeSky(const SkyCoefficients& coefficients, const Vec3& sun);

/// The traditional overcast sky, type 16: L ~ (1 + 2 sin gamma) / 3.
std::unique_ptr<SkyPattern> makeTraditionalOvercast();

/// A latitude-longitude picture of the sky, row 0 at the zenith, the last one at the nadir; its middle column is north,
/// columns to the right of it are east.
struct SkyMap
{
  int width = 0, height = 0;
  std::vector<float> luminance;  ///< cd/m2, row by row
};
std::unique_ptr<SkyPattern> makeSky(const SkyMap& map, const Vec3& north);
}  // namespace kalos

#endif
