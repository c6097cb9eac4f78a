// SPDX-License-Identifier: BSD-3-Clause
// Sky, sun and ground: what a ray that leaves the scene meets.
#ifndef kalos_sky_Sky_h
#define kalos_sky_Sky_h

#include <memory>

#include "sky/DirectionTable.h"
#include "sky/SkyPattern.h"

namespace kalos
{
struct SkyDescription
{
  std::shared_ptr<const SkyPattern> pattern;
  /// lx of the sky, without the sun, on a horizontal plane; negative: see the zenith's luminance.
  double horizontalIlluminance = -1;
  double zenithLuminance = -1;  ///< cd/m2; negative too: the pattern is in cd/m2
  Vec3 sun{0, 0, 1};            ///< unit vector to the middle of the sun
  double sunIlluminance = 0;    ///< lx across its rays
  double groundReflectance = 0;
};

/// Directions point away from the scene, z is up. The sun is a disc of 0.53 degrees of uniform luminance, and only what
/// of it is above the horizon shines. Below the horizon the ground has the luminance rho E_h / pi, where E_h is the
/// horizontal illuminance of the sky without the sun.
class Sky
{
public:
  /// Throws std::invalid_argument for numbers out of range, or when the illuminance or luminance of a black pattern is
  /// asked for.
  explicit Sky(const SkyDescription& description);

  /// cd/m2 of sky or ground, without the sun.
  double luminance(const Vec3& direction) const
  {
    return direction.z > 0 ? this->Scale * this->Given.pattern->relative(direction) : this->Ground;
  }
  /// The same with the sun.
  double luminanceWithSun(const Vec3& direction) const
  {
    return this->luminance(direction) + (direction.z > 0 && this->inDisc(direction) ? this->SunLuminance : 0);
  }
  double horizontalIlluminance() const { return this->Horizontal; }  ///< lx, without the sun
  bool isUniform() const { return this->Given.pattern->isUniform(); }
  double groundLuminance() const { return this->Ground; }
  double groundReflectance() const { return this->Given.groundReflectance; }
  /// lx on an unobstructed plane of unit normal n, from sky and ground without the sun; to a relative error of 1e-6.
  double illuminance(const Vec3& n) const;

  static const double sunRadius;      ///< rad
  static const double sunSolidAngle;  ///< sr
  bool hasSun() const { return this->Given.sunIlluminance > 0; }
  const Vec3& sun() const { return this->Given.sun; }
  double sunIlluminance() const { return this->Given.sunIlluminance; }
  double sunLuminance() const { return this->SunLuminance; }  ///< cd/m2
  bool inDisc(const Vec3& direction) const;                   ///< of the sun, above the horizon or below
  Vec3 sampleSun(double u1, double u2) const;                 ///< uniform over the disc

  /// Directions in proportion to the luminance of sky and ground.
  const DirectionTable& directions() const { return *this->Directions; }

private:
  double integrate(const Vec3& n) const;  // of the pattern, relative

  SkyDescription Given;
  double Scale = 1, Horizontal = 0, Ground = 0, SunLuminance = 0;
  std::shared_ptr<const DirectionTable> Directions;
};
}  // namespace kalos

#endif
