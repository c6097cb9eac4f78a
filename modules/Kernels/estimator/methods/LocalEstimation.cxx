// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/LocalEstimation.h"

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/kernel/KernelRegularizationFactory.h"
#include "estimator/tally/IntervalDiagnostics.h"
#include "estimator/tracing/VertexDensity.h"
#include "estimator/tracing/VertexRound.h"

namespace kalos
{
namespace
{
double plannedTrajectories(const Settings& settings)
{
  return static_cast<double>(settings.trajectories ? settings.trajectories : defaultTrajectories);
}
}  // namespace

LocalEstimation::LocalEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, false),
      CollisionsPerArea(VertexDensity(scene, this->Source, settings.walks()).typical()),
      Alteration(
          makeRegularization(scene, receivers, settings, this->CollisionsPerArea * plannedTrajectories(settings)))
{
}

bool LocalEstimation::prepare(Workers& workers, Tally& tally)
{
  const auto& sensors = this->Direct.sensors();
  if (!this->Alteration)
  {
    this->NearKernel.resize(sensors.size());
    const bool probed = workers.forEach(tileCount(sensors.size()), [&](std::size_t tile) {
      for (std::size_t r = tile * tileSize; r < std::min(sensors.size(), (tile + 1) * tileSize); ++r)
        this->NearKernel[r] = nearKernel(this->Scene_, sensors[r]);
    });
    if (!probed)
      return false;
  }
  return this->Direct.prepare(workers, tally);
}

bool LocalEstimation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  const int replicates = tally.replicates();
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const std::vector<LightVertices> pools =
      traceRound(this->Scene_, this->Source, this->Settings_.walks(), replicates, first, count, workers);
  if (pools.empty())
    return false;
  tally.noteEnergy(pools);

  // A task owns its tile and replicate, so that no sum depends on the threads.
  return workers.forEachReplicate(replicates, tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
    const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
    {
      if (tally.converged(r))
        continue;
      double* total = tally.total(r, replicate);
      this->scoreVertices(r, replicate, pools[replicate].reflected, tally, total);
      this->scoreVertices(r, replicate, pools[replicate].glossy, tally, total);
      if (!this->Direct.exactMeshes(r))
      {
        Bands emitted{};
        this->scoreVertices(r, replicate, pools[replicate].emitted, tally, emitted.data());
        for (int b = 0; b < tally.bands(); ++b)
        {
          total[b] += emitted[b];
          tally.direct(r, replicate)[b] += emitted[b];
        }
      }
      this->Direct.score(r, replicate, first, count, tally);
    }
  });
}

void LocalEstimation::scoreVertices(std::size_t r, int replicate, const VertexSet& vertices, Tally& tally,
                                    double* sum) const
{
  const Sensor& sensor = this->Direct.sensors()[r];
  PairBlock block;
  for (std::size_t begin = 0; begin < vertices.size(); begin += PairBlock::capacity)
  {
    const auto count = static_cast<int>(std::min<std::size_t>(PairBlock::capacity, vertices.size() - begin));
    if (this->Alteration)
      formNearPairs(vertices, begin, count, sensor, this->Alteration->reach(r), block);
    else
      formPairs(vertices, begin, count, sensor, 0, block);
    if (this->Direct.shadows())
      keepVisible(this->Scene_.rays(), vertices, sensor, block);
    if (this->Alteration)
    {
      this->alter(r, replicate, vertices, block);
      for (int i = 0; i < block.count; ++i)
        if (block.kernel[i] != block.plain[i])
          tally.correction(r, replicate) +=
              static_cast<double>(vertices.luminous[block.index[i]]) *
              (static_cast<double>(block.kernel[i]) - static_cast<double>(block.plain[i]));
    }
    tally.noteScore(r, replicate, addScores(vertices, block, sum));
  }
}

void LocalEstimation::alter(std::size_t r, int replicate, const VertexSet& vertices, PairBlock& block) const
{
  const Sensor& sensor = this->Direct.sensors()[r];
  const double reach = this->Alteration->reach(r);
  for (int i = 0; i < block.count; ++i)
  {
    const int j = block.index[i];
    const Vec3 y = vertices.position(j), d = y - sensor.position;
    if (dot(d, d) >= reach * reach)
      continue;
    // The vertex's own number would repeat in the next round: its coordinates key the stream.
    RandomStream random = receiverStream(this->Settings_.seed, replicate, Purpose::Averaging, r, vertices.key(j));
    block.kernel[i] = static_cast<float>(
        this->Alteration->kernel(r, sensor, y, vertices.normal(j), static_cast<double>(block.plain[i]), random));
  }
}

bool LocalEstimation::trusts(std::size_t receiver, long long trajectories) const
{
  if (!this->Direct.hasAllImages())
    return false;
  return this->Alteration || this->Direct.complete() ||
         nearFieldIsSeen(this->NearKernel[receiver], this->CollisionsPerArea * static_cast<double>(trajectories));
}

std::vector<AuditLine> LocalEstimation::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  lines.push_back({"kernel", this->Alteration ? this->Alteration->describe() : "plain",
                   this->Alteration ? "biased near edges; KernelCorrection says by how much it was altered"
                                    : "unbiased, but without bound at concave edges and contacts"});
  return lines;
}
}  // namespace kalos
