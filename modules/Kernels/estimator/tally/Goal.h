// SPDX-License-Identifier: BSD-3-Clause
// When the error is small enough: at the stated share of the receivers whose value fluctuates, the 95 % half-width is
// within the relative error of the value, or below an absolute floor. Without a floor, no solve would end where hardly
// any light arrives, in closed furniture or under a box: a relative error of almost nothing is never reached. Without
// a share, the few worst of thousands hold all others up: on the floor of the furnished Cornell room `gathered` to 4 %
// took 2 to 3 times longer to the same rms error. Half-widths are judged by variances pooled over neighbours
// (estimator/tally/PooledErrors.h), so that chance does not pick the receivers that decide.
#ifndef kalos_estimator_tally_Goal_h
#define kalos_estimator_tally_Goal_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/tally/PooledErrors.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
enum class GoalStatus : char
{
  Missed = 0,       ///< trajectories or time ran out before
  WithinError = 1,  ///< the half-width is within the relative error of the value
  BelowFloor = 2    ///< the half-width is not, but below the floor: a dim value
};

class Goal
{
public:
  Goal(const Settings& settings, const Receivers& receivers, int replicates);

  /// Whether there is a goal for the error.
  bool wanted() const { return this->RelativeError > 0; }

  /// Half-width over what is allowed, after n trajectories of every replicate, below which the stated share of the
  /// receivers lies; reached at 1.
  double distance(const Tally& tally, long long n) const;

  /// Every receiver's half-width over what is allowed, in their order; 0 where nothing fluctuates. Pooled over
  /// neighbours where the share lets some receivers go, or always where `pooled`.
  std::vector<double> distances(const Tally& tally, long long n, bool pooled = false) const;

  /// Fills Result::goal and Result::errorFloor from the values of the result, after n trajectories of every replicate.
  void judge(const Tally& tally, long long n, Result& result) const;

private:
  double floorFor(double meanIlluminance) const;
  std::ptrdiff_t letGo(std::size_t receivers) const;  // of so many, how many may miss the goal

  double RelativeError, Share, Floor, Quantile;
  PooledErrors Pooled;
};
}  // namespace kalos

#endif
