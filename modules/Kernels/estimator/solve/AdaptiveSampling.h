// SPDX-License-Identifier: BSD-3-Clause
// Effort where the error is: with a goal for the error, receivers that have enough rest while others go on.
//
// A pilot, a short solve with random numbers of its own, tells how many trajectories each receiver needs. One converged
// when it has had them and its own interval agrees. What decides first is not in the estimate, so that receivers do not
// stop for being wrong by chance; the second part only adds trajectories. On a floor beside boxes the dimmest points
// need 30 times what the mean point needs.
#ifndef kalos_estimator_solve_AdaptiveSampling_h
#define kalos_estimator_solve_AdaptiveSampling_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tally/Goal.h"

namespace kalos
{
class AdaptiveSampling
{
public:
  static constexpr int pilotTrajectories = 256;  ///< of every replicate

  /// A plan by the pilot's tally.
  AdaptiveSampling(const Goal& goal, const Tally& pilot);

  /// Trajectories of every replicate that a receiver needs, by the pilot; those of neighbours in order are averaged.
  const std::vector<double>& needed() const { return this->Needed; }

  /// Which receivers rest after `done` trajectories of every replicate: see Tally::setConverged().
  std::vector<char> converged(const Goal& goal, const Tally& tally, long long done) const;

private:
  std::vector<double> Needed;
};

/// Runs the pilot of a solve. Empty when aborted.
std::unique_ptr<AdaptiveSampling> planEffort(const Scene& scene, const Receivers& receivers, const Settings& settings,
                                             const Goal& goal, int replicates, const Ranks& ranks, Workers& workers);

/// What resting has spared, after `done` trajectories of every replicate.
AuditLine auditEffort(const Tally& tally, long long done);
}  // namespace kalos

#endif
