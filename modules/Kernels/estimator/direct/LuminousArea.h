// SPDX-License-Identifier: BSD-3-Clause
// A flat emitter as a receiver sees it: a luminous rectangle, a measured luminaire's opening, an emitting triangle.
#ifndef kalos_estimator_direct_LuminousArea_h
#define kalos_estimator_direct_LuminousArea_h

#include "estimator/kernel/Sensor.h"
#include "luminaire/Luminaire.h"

namespace kalos
{
/// A point of an area emitter, as seen from a sensor.
struct AreaSample
{
  Vec3 direction;
  RayAnchor target;
  std::size_t luminaire = 0;
  double solidAngle;  ///< sr, of the emitter; or what stands for it, one over the direction's density
};

struct LuminousArea
{
  Vec3 corner[4];
  int count;                           ///< corners, 3 or 4
  Vec3 normal;                         ///< light leaves on this side
  Bands exitance;                      ///< lm/m2
  const Luminaire* opening = nullptr;  ///< of a measured distribution; null: Lambertian
  RayAnchor anchor;                    ///< of one of its points

  /// An opening that shines on both sides.
  bool isTwoSided() const { return this->opening && !this->opening->isOneSided(); }

  RayAnchor anchorAt(const Vec3& p, bool behind) const;

  /// Pi times the luminance towards a sensor, lm/m2.
  Bands exitanceTowards(const Vec3& fromSensor) const;

  double solidAngle(const Vec3& from) const;  ///< sr

  /// Whether a ray meets it on a lit side, and how many lengths of its direction away.
  bool meets(const Vec3& origin, const Vec3& direction, double& distance) const;

  /// A direction uniform in solid angle; from afar, and without BRDF, uniform on the area, which costs a tenth.
  /// False when the emitter is not seen there.
  bool sample(const Sensor& sensor, double u1, double u2, double u3, AreaSample& sample) const;

private:
  bool isAfar(const Vec3& p) const;
  bool samplePoint(const Sensor& sensor, double u1, double u2, AreaSample& sample) const;
};
}  // namespace kalos

#endif
