// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/Goal.h"

#include <algorithm>
#include <numeric>
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

namespace kalos
{
Goal::Goal(const Settings& settings, const Receivers& receivers, int replicates)
    : RelativeError(settings.relativeError),
      Share(settings.errorShare),
      Floor(settings.errorFloor),
      Quantile(studentQuantile(0.95, replicates - 1)),
      Pooled(receivers)
{
}

double Goal::floorFor(double meanIlluminance) const
{
  constexpr double dim = 0.01;  // of the mean over all receivers; smaller values need only this accuracy
  return this->Floor >= 0 ? this->Floor : dim * this->RelativeError * meanIlluminance;
}

std::vector<double> Goal::distances(const Tally& tally, long long n, bool pooled) const
{
  std::vector<MeanAndError> found;
  double sum = 0;
  for (std::size_t r = 0; r < tally.receivers(); ++r)
  {
    found.push_back(tally.summary(r, n));
    sum += found.back().mean;
  }
  const double floor = this->floorFor(sum / static_cast<double>(std::max<std::size_t>(1, found.size())));
  // Neighbours may have had other numbers of trajectories: what they share is the variance of one.
  std::vector<double> squares;
  squares.reserve(found.size());
  for (std::size_t r = 0; r < found.size(); ++r)
  {
    const double allowed = std::max(floor, this->RelativeError * std::abs(found[r].mean));
    const double own = found[r].standardError > 0 ? this->Quantile * found[r].standardError / allowed : 0;
    squares.push_back(own * own * static_cast<double>(tally.trajectories(r, n)));
  }
  const auto fluctuating = squares.size() - static_cast<std::size_t>(std::count(squares.begin(), squares.end(), 0.0));
  std::vector<double> distances = pooled || this->letGo(fluctuating) > 0 ? this->Pooled.pool(squares) : squares;
  for (std::size_t r = 0; r < found.size(); ++r)
    distances[r] = std::sqrt(distances[r] / static_cast<double>(tally.trajectories(r, n)));
  return distances;
}

std::ptrdiff_t Goal::letGo(std::size_t receivers) const
{
  return static_cast<std::ptrdiff_t>((1 - this->Share) * static_cast<double>(receivers));
}

double Goal::distance(const Tally& tally, long long n) const
{
  std::vector<double> all = this->distances(tally, n);
  all.erase(std::remove(all.begin(), all.end(), 0.0), all.end());
  if (all.empty())
    return 0;
  const std::ptrdiff_t beyond = this->letGo(all.size());
  std::nth_element(all.begin(), all.end() - 1 - beyond, all.end());
  return *(all.end() - 1 - beyond);
}

void Goal::judge(const Tally& tally, long long n, Result& result) const
{
  result.goal.clear();
  if (!this->wanted())
    return;
  const std::vector<double>& values = result.illuminance;
  result.errorFloor = this->floorFor(std::accumulate(values.begin(), values.end(), 0.0) /
                                     static_cast<double>(std::max<std::size_t>(1, values.size())));
  const std::vector<double> distances = this->distances(tally, n);
  for (std::size_t r = 0; r < values.size(); ++r)
  {
    const double halfWidth = distances[r] * std::max(result.errorFloor, this->RelativeError * std::abs(values[r]));
    const bool within = values[r] != 0 && halfWidth <= this->RelativeError * std::abs(values[r]);
    const GoalStatus status = within                           ? GoalStatus::WithinError
                              : halfWidth <= result.errorFloor ? GoalStatus::BelowFloor
                                                               : GoalStatus::Missed;
    result.goal.push_back(static_cast<char>(status));
  }
}
}  // namespace kalos
