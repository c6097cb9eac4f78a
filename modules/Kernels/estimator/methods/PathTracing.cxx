// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/PathTracing.h"

#include "estimator/gathering/ReceiverRays.h"

namespace kalos
{
namespace
{
constexpr double noVertices = std::numeric_limits<double>::infinity();  // gather rays per trajectory that scores
}  // namespace

PathTracing::PathTracing(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, false),
      Rays(scene, this->Source, settings, this->Direct.shadows())
{
  this->Rays.usePathsOnly(true);
}

bool PathTracing::prepare(Workers& workers, Tally& tally)
{
  return this->Direct.prepare(workers, tally);
}

Pace PathTracing::pace() const
{
  Pace pace;
  pace.smallest = 16;
  pace.work = 64;  // a path takes about as long as scoring the vertices of so many trajectories
  return pace;
}

bool PathTracing::drawStarts(long long first, int count, std::vector<LightVertices>& pools, Workers& workers) const
{
  return workers.forEachReplicate(static_cast<int>(pools.size()), 1, [&](int replicate, std::size_t) {
    VertexSet& starts = pools[replicate].emitted = VertexSet(this->Rays.scene().bands());
    for (long long i = first; i < first + count; ++i)
    {
      SampleStream random = this->Settings_.walks().stream(replicate, Purpose::Trajectory, i);
      const EmissionSample start = this->Source.sample(random);
      if (start.onSurface)
        starts.add(start.anchor, start.weight, 1 / start.density);
    }
  });
}

bool PathTracing::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  std::vector<LightVertices> pools =
      this->Rays.trace(this->Source, this->Settings_.walks(), tally.replicates(), first, count, workers);
  if (pools.empty() || !this->drawStarts(first, count, pools, workers))
    return false;
  tally.noteEnergy(pools);

  // A task owns its tile and replicate, so that no sum depends on the threads.
  return workers.forEachReplicate(
      tally.replicates(), tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
        const GatherPool pool{&pools[replicate], count};
        ReceiverRays paths(this->Rays, pool, replicate, tally);
        const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
        for (std::size_t r = tile * tileSize; r < end; ++r)
        {
          if (tally.converged(r))
            continue;
          const Sensor& sensor = this->Direct.sensors()[r];
          const Walks walks = this->Settings_.walks().ofReceiver(r);
          const WavefrontGather::Start start{noVertices, !this->Direct.exactMeshes(r), sensor.doublePrecision};
          for (long long k = first; k < first + count; ++k)
            paths.gather(r, count, sensor, start, walks.stream(replicate, Purpose::Gather, k));
          this->Direct.score(r, replicate, first, count, tally);
        }
        paths.finish();
      });
}

std::vector<AuditLine> PathTracing::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  lines.push_back({"paths", "from every receiver, one per trajectory",
                   "next event estimation at each bounce: unbiased, and independent of the trajectories' vertices"});
  return lines;
}
}  // namespace kalos
