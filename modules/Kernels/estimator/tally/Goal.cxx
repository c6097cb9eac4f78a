// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/Goal.h"

#include <algorithm>
#include <numeric>
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

namespace kalos
{
Goal::Goal(const Settings& settings, int replicates)
    : RelativeError(settings.relativeError), Floor(settings.errorFloor), Quantile(studentQuantile(0.95, replicates - 1))
{
}

double Goal::floorFor(double meanIlluminance) const
{
  constexpr double dim = 0.01;  // of the mean over all receivers; smaller values need only this accuracy
  return this->Floor >= 0 ? this->Floor : dim * this->RelativeError * meanIlluminance;
}

std::vector<double> Goal::distances(const Tally& tally, long long n) const
{
  std::vector<MeanAndError> found;
  double sum = 0;
  for (std::size_t r = 0; r < tally.receivers(); ++r)
  {
    found.push_back(tally.summary(r, n));
    sum += found.back().mean;
  }
  const double floor = this->floorFor(sum / static_cast<double>(std::max<std::size_t>(1, found.size())));
  std::vector<double> distances;
  distances.reserve(found.size());
  for (const MeanAndError& m : found)
    distances.push_back(m.standardError > 0
                            ? this->Quantile * m.standardError / std::max(floor, this->RelativeError * std::abs(m.mean))
                            : 0);
  return distances;
}

double Goal::distance(const Tally& tally, long long n) const
{
  const std::vector<double> all = this->distances(tally, n);
  return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
}

void Goal::judge(Result& result) const
{
  result.goal.clear();
  if (!this->wanted())
    return;
  const std::vector<double>& values = result.illuminance;
  result.errorFloor = this->floorFor(std::accumulate(values.begin(), values.end(), 0.0) /
                                     static_cast<double>(std::max<std::size_t>(1, values.size())));
  for (std::size_t r = 0; r < values.size(); ++r)
  {
    const double halfWidth = this->Quantile * result.standardError[r];
    const bool within = values[r] != 0 && halfWidth <= this->RelativeError * std::abs(values[r]);
    const GoalStatus status = within                           ? GoalStatus::WithinError
                              : halfWidth <= result.errorFloor ? GoalStatus::BelowFloor
                                                               : GoalStatus::Missed;
    result.goal.push_back(static_cast<char>(status));
  }
}
}  // namespace kalos
