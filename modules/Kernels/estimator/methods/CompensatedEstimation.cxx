// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/CompensatedEstimation.h"

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/StrategyTrial.h"

namespace kalos
{
CompensatedEstimation::CompensatedEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, true),
      Light(scene, this->Source, settings, this->Direct.shadows(), receivers.points.size()),
      EdgeDistances(receivers.edgeDistances)
{
}

bool CompensatedEstimation::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  if (!this->Direct.prepare(workers, tally))
    return false;
  if (this->Direct.complete())
    return true;
  if (pathsAreBetter(this->Scene_, this->Source, this->Settings_, this->Direct))
  {
    this->Light.usePathsOnly();
    this->Direct.leaveMeshesToRays();
    this->Direct.prepare(workers, tally);
  }
  return this->Light.prepare(this->Direct.sensors(), workers);
}

bool CompensatedEstimation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const int replicates = tally.replicates();
  const Round round = this->Light.trace(first, count, replicates, workers);
  if (round.pools.empty())
    return false;
  tally.noteEnergy(round.pools);

  // A task owns its tile and replicate, so that no sum depends on the threads.
  const bool scored =
      workers.forEachReplicate(replicates, tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
        const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
        this->Light.score(
            this->Direct.sensors(), tile * tileSize, end, replicate, round,
            [this](std::size_t r) { return this->Direct.exactMeshes(r); }, tally);
        for (std::size_t r = tile * tileSize; r < end; ++r)
          this->Direct.score(r, replicate, first, count, tally);
      });
  this->Light.finish(round, tally);
  return scored;
}

std::vector<double> CompensatedEstimation::gatherRays() const
{
  return this->Light.raysSent(this->Replicates);
}

std::vector<AuditLine> CompensatedEstimation::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  lines.push_back({"kernel", "compensated", "bounded and unbiased; more gather rays where surfaces are near"});
  if (this->Light.gathering().pathsOnly())
    lines.push_back(auditPaths());
  if (!this->Direct.complete())
    lines.push_back(this->Light.audit(this->Replicates, this->EdgeDistances));
  return lines;
}
}  // namespace kalos
