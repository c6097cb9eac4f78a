// SPDX-License-Identifier: BSD-3-Clause
// Decides how many trajectories per replicate the next round of a solve has.
#ifndef kalos_estimator_solve_Schedule_h
#define kalos_estimator_solve_Schedule_h

#include "estimator/control/Settings.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tally/Goal.h"

namespace kalos
{
class Schedule
{
public:
  /// With `shown`, rounds begin with one trajectory of every replicate and grow by half of what is done.
  Schedule(const Settings& settings, const Tally& tally, const Pace& pace, bool shown);

  /// Trajectories of a solve without limit.
  static constexpr long long unlimited = std::numeric_limits<long long>::max() / 64;

  /// Limit over all replicates.
  static long long limitFor(const Settings& settings);

  /// Trajectories of every replicate in the next round, after `done` of them and so many seconds; 0 when the work is
  /// done.
  int next(long long done, double seconds, const Tally& tally);

  /// How much of the whole work next() found to be done.
  double fraction() const { return std::min(1.0, this->Fraction); }

  /// How much will be done with the coming round of `count`.
  double fractionAfter(long long done, int count) const;

  const Goal& goal() const { return this->Wished; }

private:
  bool hasGoal() const { return this->Settings_.relativeError > 0 || this->Settings_.seconds > 0; }
  long long targetByGoals(long long done, double seconds, const Tally& tally);
  int largest(const Tally& tally) const;

  Settings Settings_;
  bool Shown;
  int Replicates;
  long long Limit;  // of a replicate
  Pace Paced;
  Goal Wished;
  double Fraction = 0;
};
}  // namespace kalos

#endif
