// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/HotSpots.h"

#include "sampling/Sobol.h"

namespace kalos
{
namespace
{
constexpr double mostPairs = 1 << 24;  // of receivers and rays
constexpr double mostRays = 64;        // of a lamp
}  // namespace

HotSpots::HotSpots(const Scene& scene, std::size_t receivers)
{
  const auto& luminaires = scene.data().luminaires;
  const double all = std::clamp(mostPairs / static_cast<double>(std::max<std::size_t>(1, receivers)), 64.0, 4096.0);
  const double each = std::clamp(all / static_cast<double>(std::max<std::size_t>(1, luminaires.size())), 1.0, mostRays);
  const std::size_t step = 1 + static_cast<std::size_t>(static_cast<double>(luminaires.size()) / all);
  for (std::size_t l = 0; l < luminaires.size(); l += step)
  {
    const Luminaire& lamp = luminaires[l];
    if (!lamp.isPoint() || !(lamp.flux > 0))
      continue;
    const auto rays = static_cast<std::uint32_t>(each);
    for (std::uint32_t i = 0; i < rays; ++i)
    {
      double u1, u2;
      sobolPoint(1, i, u1, u2);
      const SurfacePoint y = scene.trace(scene.luminaireAnchor(l), sampleDirection(lamp, u1, u2));
      if (!y.valid)
        continue;
      const Vec3 d = y.position - lamp.position;
      const double reflectance = photometric(scene.material(y.triangle).reflectance, scene.bands());
      const double flux = static_cast<double>(step) * lamp.flux * reflectance / rays;
      this->Spots.push_back({y.position, y.normal, flux, pi * dot(d, d)});
    }
  }
}

bool HotSpots::areSeen(const Sensor& sensor, double rays, double direct) const
{
  double known = direct, missed = 0;
  for (const Spot& spot : this->Spots)
  {
    const Vec3 d = spot.position - sensor.position;
    const double squared = dot(d, d), here = dot(d, sensor.normal), there = -dot(d, spot.normal);
    if (!(here > 0 && there > 0))
      continue;
    const double kernel = here * there / (pi * squared * squared), light = spot.flux * kernel;
    known += light;
    missed += rays * kernel * spot.area < fewestRays ? light : 0;
  }
  return missed <= largestShare * known;
}
}  // namespace kalos
