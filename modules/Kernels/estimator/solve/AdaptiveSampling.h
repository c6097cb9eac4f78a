// SPDX-License-Identifier: BSD-3-Clause
// Also known as: adaptive sampling with a pilot (two-stage sampling).
//
// With a goal for the error, receivers that reached the goal are skipped and the others continue.
//
// A pilot, a short solve with its own random numbers, estimates how many trajectories each receiver needs. A receiver
// has converged when it has had them and its interval meets the goal. The pilot is independent of the estimate, so
// no receiver stops because its estimate is wrong by chance; the second condition only adds trajectories. On a floor
// beside boxes the dimmest points need 30 times what the mean point needs.
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

  /// Trajectories of every replicate that a receiver needs, by the pilot.
  const std::vector<double>& needed() const { return this->Needed; }

  /// Which receivers have converged after `done` trajectories of every replicate: see Tally::setConverged().
  std::vector<char> converged(const Goal& goal, const Tally& tally, long long done) const;

private:
  std::vector<double> Needed;
};

/// Runs the pilot of a solve. Empty when aborted.
std::unique_ptr<AdaptiveSampling> planEffort(const Scene& scene, const Receivers& receivers, const Settings& settings,
                                             const Goal& goal, int replicates, const Ranks& ranks, Workers& workers);

/// The trajectories saved by skipping converged receivers, after `done` of every replicate.
AuditLine auditEffort(const Tally& tally, long long done);
}  // namespace kalos

#endif
