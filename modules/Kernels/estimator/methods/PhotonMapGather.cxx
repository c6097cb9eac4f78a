// SPDX-License-Identifier: BSD-3-Clause
// The final gather of the photon map.
#include "estimator/methods/PhotonMap.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr int trajectoriesPerRay = 16;  // of a replicate, for each of a receiver's rays
}  // namespace

void PhotonMap::gather(std::size_t r, int replicate, long long first, int count, const PhotonTree& map, double radius,
                       Tally& tally) const
{
  const Sensor& sensor = this->Direct.sensors()[r];
  const Reading reading{map, this->lookup(radius, true), count};
  const bool exact = this->Direct.exactMeshes(r);
  const int rays = (count + trajectoriesPerRay - 1) / trajectoriesPerRay;
  const double weight = static_cast<double>(count) / rays;
  const Walks walks = this->Settings_.walks().ofReceiver(r);
  for (int k = 0; k < rays; ++k)
  {
    SampleStream random = walks.stream(replicate, Purpose::Gather, first + k);
    const double u1 = random.next(), u2 = random.next();
    const Vec3 direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    const Seen found = this->lookAlong(sensor, direction, !exact, reading, random);
    for (int b = 0; b < tally.bands(); ++b)
    {
      tally.total(r, replicate)[b] += weight * found.light[b];
      tally.direct(r, replicate)[b] += weight * found.exitance[b];
    }
    tally.noteScore(r, replicate, weight * photometric(found.light, tally.bands()));
  }
}

PhotonMap::Seen PhotonMap::lookAlong(const Sensor& from, Vec3 direction, bool seesEmission, const Reading& map,
                                     SampleStream& random) const
{
  Seen seen;
  const int bands = this->Scene_.bands();
  RayAnchor start = from.anchor;
  SurfacePoint y = this->Scene_.trace(start, direction);
  for (bool first = true; y.valid; first = false)
  {
    const Brdf& brdf = this->Scene_.brdf(y.triangle);
    const Material& material = brdf.material();
    for (int b = 0; b < bands && y.front && (seesEmission || !first); ++b)
    {
      seen.light[b] += material.exitance[b];
      seen.exitance[b] += first ? material.exitance[b] : 0;
    }
    start = this->Scene_.anchor(y);
    if (!(material.mirror > 0) || random.next() >= material.mirror)  // the mirror is followed with its share
    {
      Sensor at(start);
      at.brdf = &brdf;
      at.outgoing = -direction;
      const Bands lamps = this->Rays.luminaireLight(at, random);
      const Bands photons = map.photons.estimate(at, map.lookup).light;
      for (int b = 0; b < bands; ++b)
        seen.light[b] += (lamps[b] + photons[b] / map.trajectories) / (1 - material.mirror);
      break;
    }
    direction = reflected(-direction, y.normal);
    y = this->Scene_.trace(start, direction);
    this->Rays.luminaires().addSeen(start.lifted(), direction, y, uniformBands(1), seen.light.data());
  }
  return seen;
}
}  // namespace kalos
