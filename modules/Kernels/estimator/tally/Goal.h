// SPDX-License-Identifier: BSD-3-Clause
// When the error is small enough: every receiver's 95 % half-width is within the relative error of its value, or below
// an absolute floor. Without a floor, no solve would end where hardly any light arrives, in closed furniture or under a
// box: a relative error of almost nothing is never reached.
#ifndef kalos_estimator_tally_Goal_h
#define kalos_estimator_tally_Goal_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
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
  Goal(const Settings& settings, int replicates);

  /// Whether there is a goal for the error.
  bool wanted() const { return this->RelativeError > 0; }

  /// Largest half-width over what is allowed, after n trajectories of every replicate; reached at 1.
  double distance(const Tally& tally, long long n) const;

  /// The same for every receiver, in their order; 0 where nothing fluctuates.
  std::vector<double> distances(const Tally& tally, long long n) const;

  /// Fills Result::goal and Result::errorFloor from the values of the result.
  void judge(Result& result) const;

private:
  double floorFor(double meanIlluminance) const;

  double RelativeError, Floor, Quantile;
};
}  // namespace kalos

#endif
