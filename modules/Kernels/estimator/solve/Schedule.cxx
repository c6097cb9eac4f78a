// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Schedule.h"

namespace kalos
{
namespace
{
constexpr int largestRound = 8192;       // trajectories per replicate: bounds the memory of the vertices
constexpr int firstRound = 64;           // with a goal: enough for a first standard error
constexpr double largestWork = 1 << 25;  // scores of trajectories: a stop loses the round that it interrupts
}  // namespace

Schedule::Schedule(const Settings& settings, const Tally& tally, const Pace& pace, bool shown)
    : Settings_(settings),
      Shown(shown),
      Replicates(tally.replicates()),
      Limit((limitFor(settings) + tally.replicates() - 1) / tally.replicates()),
      Paced(pace),
      Wished(settings, tally.replicates())
{
}

long long Schedule::limitFor(const Settings& settings)
{
  if (settings.trajectories)
    return settings.trajectories;
  return settings.relativeError > 0 || settings.seconds > 0 ? unlimited : defaultTrajectories;
}

// Trajectories by which the goals are expected to be met; `done` when they are.
long long Schedule::targetByGoals(long long done, double seconds, const Tally& tally)
{
  long long target = std::max<long long>(firstRound, (tally.active() < tally.receivers() ? 2 : 4) * done);
  if (this->Settings_.relativeError > 0 && done >= firstRound)
  {
    // The variance falls as 1/n: aim a little beyond the goal, so that one more round mostly suffices.
    const double ratio = this->Wished.distance(tally, done);
    if (ratio <= 1)
      return done;
    this->Fraction = std::max(this->Fraction, 1 / (ratio * ratio));
    const double aim = 1.1 * ratio * ratio * static_cast<double>(done);
    target = std::min(target, static_cast<long long>(std::min(aim, static_cast<double>(unlimited))) + 1);
  }
  if (this->Settings_.seconds > 0 && done > 0)
  {
    const double left = this->Settings_.seconds - seconds, each = seconds / static_cast<double>(done);
    this->Fraction = std::max(this->Fraction, seconds / this->Settings_.seconds);
    if (left < each)
      return done;
    target = std::min(target, done + static_cast<long long>(0.9 * left / each) + 1);
  }
  return target;
}

int Schedule::next(long long done, double seconds, const Tally& tally)
{
  long long target = this->Limit;
  this->Fraction = static_cast<double>(done) / static_cast<double>(this->Limit);
  if (this->hasGoal())
  {
    target = this->targetByGoals(done, seconds, tally);
    if (target <= done)
      return 0;
  }
  if (this->Shown)
    target = std::min(target, done + std::max(1LL, done / 2));
  const int multiple = this->Paced.multiple;
  const long long wished = (target - done + multiple - 1) / multiple * multiple;
  const long long count = std::min<long long>(this->largest(tally), wished), left = this->Limit - done;
  return static_cast<int>(left < count + multiple ? left : count);
}

double Schedule::fractionAfter(long long done, int count) const
{
  if (this->hasGoal())
    return this->fraction();
  return static_cast<double>(done + count) * this->Replicates / static_cast<double>(limitFor(this->Settings_));
}

// A power of two, because a Sobol' sequence is evenly stratified over that many points.
int Schedule::largest(const Tally& tally) const
{
  const double scores = static_cast<double>(tally.active()) * tally.replicates() * this->Paced.work;
  int count = this->Paced.smallest;
  while (2 * count <= largestRound && 2 * count * scores <= largestWork)
    count *= 2;
  return count;
}
}  // namespace kalos
