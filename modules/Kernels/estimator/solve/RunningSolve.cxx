// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/RunningSolve.h"

#include <stdexcept>

#include "estimator/kernel/KernelRegularization.h"
#include "estimator/methods/EstimatorFactory.h"

namespace kalos
{
namespace
{
void check(const Receivers& receivers, const Settings& s)
{
  auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw std::invalid_argument(message);
  };
  require(s.trajectories >= 0, "trajectories: must be 0 (automatic) or more");
  require(s.relativeError >= 0 && s.relativeError < 1, "error: must lie in [0, 1)");
  require(std::isfinite(s.errorFloor), "error_floor: must be a half-width in lux, or negative (automatic)");
  require(s.seconds >= 0 && std::isfinite(s.seconds), "time: must be 0 (no limit) or more seconds");
  require(s.threads >= 0, "threads: must be 0 (all) or more");
  require(receivers.points.size() == receivers.normals.size(), "receivers: one normal per point is expected");
  for (std::size_t i = 0; i < receivers.points.size(); ++i)
  {
    require(isFinite(receivers.points[i]), "receiver " + std::to_string(i) + ": coordinates must be finite");
    require(std::abs(length(receivers.normals[i]) - 1) < 1e-3,
            "receiver " + std::to_string(i) + ": its normal must be a unit vector");
  }
}

std::unique_ptr<Estimator> makeChecked(const Scene& scene, const Receivers& receivers, const Settings& settings,
                                       const Ranks& ranks)
{
  check(receivers, settings);
  neighbourhood(scene, settings, 0);  // rejects invalid delta and epsilon for every method
  std::unique_ptr<Estimator> estimator;
  ranks.together([&] { return (estimator = makeEstimator(scene, receivers, settings)) != nullptr; });
  return estimator;
}

// Of Estimator::replicates(): as many as a solve of no certain length takes.
constexpr long long trajectoriesOfGoals = 32;

int replicatesOf(const Estimator& estimator, const Settings& settings)
{
  const bool goal = settings.relativeError > 0 || settings.seconds > 0;
  return estimator.replicates(goal ? trajectoriesOfGoals : Schedule::limitFor(settings));
}
}  // namespace

RunningSolve::RunningSolve(const Scene& inScene, const Receivers& atReceivers, const Settings& withSettings,
                           const Progress& progress, bool shown)
    : scene(inScene),
      receivers(atReceivers),
      settings(withSettings),
      ranks(withSettings.ranks ? *withSettings.ranks : this->oneProcess),
      estimator(makeChecked(inScene, atReceivers, withSettings, this->ranks)),
      workers(withSettings.threads, progress, this->ranks),
      tally(inScene, atReceivers.points.size(), replicatesOf(*this->estimator, withSettings)),
      schedule(withSettings, this->tally, this->estimator->pace(), shown)
{
}

bool RunningSolve::prepare()
{
  return this->ranks.together([&] { return this->estimator->prepare(this->workers, this->tally); });
}

bool RunningSolve::addRound(int count)
{
  if (!this->ranks.together([&] { return this->estimator->addRound(this->done, count, this->workers, this->tally); }))
    return false;
  this->tally.exchange(this->ranks);
  if (this->done > 0)
    this->tally.keepConverged(this->done, count);
  this->estimator->exchange(this->ranks);
  this->done += count;
  return true;
}
}  // namespace kalos
