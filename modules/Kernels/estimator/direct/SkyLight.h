// SPDX-License-Identifier: BSD-3-Clause
// Also known as: next event estimation of an environment map with portals and MIS (balance heuristic).
//
// Directions in which a sensor looks for light of the sky, the ground and the sun. They are drawn from a mixture: the
// sun's disc, the solid angle of an opening, the sensor's cosine, the sky's luminance. The contribution is
// L cos(theta) over the density of the whole mixture, so that an opening nobody found costs noise but no bias.
#ifndef kalos_estimator_direct_SkyLight_h
#define kalos_estimator_direct_SkyLight_h

#include "estimator/kernel/Sensor.h"
#include "scene/SkyOpenings.h"

namespace kalos
{
class SkyLight
{
public:
  /// `openings` may be null. Without a sky nothing is drawn.
  SkyLight(const Scene& scene, const SkyOpenings* openings);

  bool any() const { return this->Scene_.data().sky != nullptr; }
  const Sky& sky() const { return *this->Scene_.data().sky; }

  /// The probabilities of the techniques at one sensor.
  struct Mixture
  {
    double sun = 0, opening = 0;     // the others share the rest
    std::vector<double> cumulative;  // of the openings, in proportion to about the light that each lets in
    double openings() const { return this->cumulative.empty() ? 0 : this->cumulative.back(); }
    double share(std::size_t i) const { return this->cumulative[i] - (i ? this->cumulative[i - 1] : 0); }
  };
  /// Without the sun, it is not drawn.
  void mix(const Sensor& sensor, bool withSun, Mixture& mixture) const;

  /// A direction and its density, per sr; false when it lies below the sensor's horizon.
  bool sample(const Sensor& sensor, const Mixture& mixture, double u0, double u1, double u2, Vec3& direction,
              double& density) const;

  /// Density of sample().
  double density(const Sensor& sensor, const Mixture& mixture, const Vec3& direction) const;

  /// The end of a shadow ray along `direction`, beyond all surfaces.
  RayAnchor target(const Vec3& from, const Vec3& direction) const
  {
    return from + 4 * (this->Scene_.size() + length(from)) * direction;
  }

private:
  double openingDensity(const SkyOpenings::Rectangle& r, const Vec3& from, const Vec3& direction) const;

  const Scene& Scene_;
  const SkyOpenings* Openings;
};
}  // namespace kalos

#endif
