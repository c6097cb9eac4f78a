// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/AdaptiveSampling.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/EstimatorFactory.h"

namespace kalos
{
AdaptiveSampling::AdaptiveSampling(const Goal& goal, const Tally& pilot)
{
  for (const double distance : goal.distances(pilot, pilotTrajectories, true))
    this->Needed.push_back(pilotTrajectories * distance * distance);
}

std::vector<char> AdaptiveSampling::converged(const Goal& goal, const Tally& tally, long long done) const
{
  const std::vector<double> distances = goal.distances(tally, done);
  std::vector<char> reached;
  for (std::size_t r = 0; r < distances.size(); ++r)
    reached.push_back(static_cast<double>(done) >= this->Needed[r] && distances[r] <= 1);
  return reached;
}

std::unique_ptr<AdaptiveSampling> planEffort(const Scene& scene, const Receivers& receivers, const Settings& settings,
                                             const Goal& goal, int replicates, const Ranks& ranks, Workers& workers)
{
  Settings trial = settings;
  trial.seed = mixBits(settings.seed + 0x65666f7274);
  std::unique_ptr<Estimator> estimator;
  Tally tally(scene, receivers.points.size(), replicates);
  const bool ran = ranks.together([&] {
    estimator = makeEstimator(scene, receivers, trial);
    return estimator->prepare(workers, tally) &&
           estimator->addRound(0, AdaptiveSampling::pilotTrajectories, workers, tally);
  });
  if (!ran)
    return nullptr;
  tally.exchange(ranks);
  return std::make_unique<AdaptiveSampling>(goal, tally);
}

AuditLine auditEffort(const Tally& tally, long long done)
{
  double spared = 0;
  for (std::size_t r = 0; r < tally.receivers(); ++r)
    spared += static_cast<double>(done - tally.trajectories(r, done));
  const double all = static_cast<double>(done) * static_cast<double>(tally.receivers());
  std::ostringstream share;
  share << std::setprecision(3) << 100 * (1 - spared / all)
        << " % of the trajectories scored at each receiver, in the mean";
  return {"effort", share.str(), "receivers that reached the goal are skipped, by a pilot with its own random numbers"};
}
}  // namespace kalos
