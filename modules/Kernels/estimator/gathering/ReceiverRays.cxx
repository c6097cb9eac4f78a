// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/ReceiverRays.h"

namespace kalos
{
namespace
{
constexpr std::size_t together = 256;  // rays; their state fits in the second-level cache
}

ReceiverRays::ReceiverRays(const GatherContext& gathering, const GatherPool& pool, int replicate, Tally& tally)
    : Pool(pool), Replicate(replicate), Scores(tally), Wave(gathering, pool)
{
}

void ReceiverRays::gather(std::size_t receiver, int rays, const Sensor& sensor, const WavefrontGather::Start& start,
                          const SampleStream& random)
{
  this->Wave.gather(sensor, start, random);
  this->add(receiver, rays);
}

void ReceiverRays::follow(std::size_t receiver, int rays, const Sensor& sensor, const Vec3& direction,
                          const SurfacePoint& y, const WavefrontGather::Start& start, const SampleStream& random)
{
  this->Wave.follow(sensor, direction, y, start, random);
  this->add(receiver, rays);
}

void ReceiverRays::add(std::size_t receiver, int rays)
{
  this->Owners.push_back({receiver, static_cast<double>(this->Pool.trajectories) / rays});
  if (this->Owners.size() == together)
    this->finish();
}

void ReceiverRays::finish()
{
  this->Wave.run();
  for (std::size_t i = 0; i < this->Owners.size(); ++i)
  {
    const auto [r, weight] = this->Owners[i];
    const double *light = this->Wave.light(i), *emission = this->Wave.emission(i);
    this->Scores.noteScore(r, this->Replicate, weight * photometric(light, this->Scores.bands()));
    for (int b = 0; b < this->Scores.bands(); ++b)
    {
      this->Scores.total(r, this->Replicate)[b] += weight * light[b];
      this->Scores.direct(r, this->Replicate)[b] += weight * emission[b];
    }
  }
  this->Owners.clear();
  this->Wave.clear();
}
}  // namespace kalos
