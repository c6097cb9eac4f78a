// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Replay.h"

#include <stdexcept>

#include "estimator/solve/RunningSolve.h"

namespace kalos
{
namespace
{
void require(bool condition, const std::string& message)
{
  if (!condition)
    throw std::invalid_argument("replay: " + message);
}

void requireBelow(long long value, long long end, const std::string& what)
{
  require(value >= 0 && value < end,
          what + " " + std::to_string(value) + " is not there; expected 0 to " + std::to_string(end - 1));
}
}  // namespace

Replay replay(const Scene& scene, const Receivers& receivers, const Settings& settings, std::size_t receiver,
              int replicate)
{
  Settings alone = settings;
  alone.ranks = nullptr;
  RunningSolve run(scene, receivers, alone, {}, false);
  require(settings.relativeError == 0 && settings.seconds == 0,
          "the solve has a goal, so that its rounds depend on all receivers; expected only trajectories");
  requireBelow(static_cast<long long>(receiver), static_cast<long long>(receivers.points.size()), "receiver");
  Replay found;
  found.replicates = run.tally.replicates();
  requireBelow(replicate, found.replicates, "replicate");

  run.prepare();
  run.workers.only(replicate);
  const int bands = scene.bands();
  found.fixed = photometric(run.tally.fixed(receiver), bands);
  RoundScores before;
  while (const int count = run.schedule.next(run.done, 0, run.tally))
  {
    const long long first = run.done;
    run.addRound(count);
    const double sum = photometric(run.tally.total(receiver, replicate), bands);
    const double direct = photometric(run.tally.direct(receiver, replicate), bands);
    found.rounds.push_back(
        {first, count, sum - before.sum, direct - before.direct, run.tally.largest(receiver, replicate)});
    before.sum = sum;
    before.direct = direct;
  }
  found.trajectories = run.done;
  found.estimate = found.fixed + before.sum / static_cast<double>(found.trajectories);
  return found;
}
}  // namespace kalos
