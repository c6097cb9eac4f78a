// SPDX-License-Identifier: BSD-3-Clause
// Point luminaires seen in plane mirrors: no gather ray can meet a point, but its mirror image has a closed form.
#ifndef kalos_estimator_MirrorImages_h
#define kalos_estimator_MirrorImages_h

#include <vector>

#include "estimator/Sensor.h"

namespace kalos
{
/// E = m I(omega) cos(theta) V / d^2 for every point luminaire and mirror triangle whose reflection the sensor sees, d
/// the way over the mirror. Exact for one mirror; light that takes two or more from a point straight to the sensor is
/// left out, and the audit says so. (Light that reaches the sensor after a diffuse reflection is not concerned:
/// trajectories follow any number of mirrors.)
class MirrorImages
{
public:
  explicit MirrorImages(const Scene& scene);

  bool any() const { return !this->Images.empty(); }

  /// Illuminance, or weighted by the response of a glossy sensor, lx per band; shadows of both ways included.
  Bands illuminance(const Sensor& sensor) const;

private:
  struct Image
  {
    std::size_t luminaire;
    std::uint32_t triangle;
    Vec3 position;
  };
  bool covers(std::uint32_t triangle, const Vec3& p) const;

  const Scene& Lit;
  std::vector<Image> Images;
};
}  // namespace kalos

#endif
