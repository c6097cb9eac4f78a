// SPDX-License-Identifier: BSD-3-Clause
// Runs a method in rounds until its goal is met.
#ifndef kalos_estimator_solve_Solver_h
#define kalos_estimator_solve_Solver_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
/// Illuminance at the receivers. Without a goal (error or seconds) it runs settings.trajectories; with one, until the
/// first of: every receiver's 95 % half-width is within the relative error, the time is up, the trajectories are used.
/// Same scene, receivers and settings (without `seconds`): bitwise the same result for any number of threads and ranks.
/// With settings.ranks every rank calls this, and all get the result; cpuSeconds is that of all of them.
/// When `progress` stops it, the result holds the rounds that were complete; without any, its arrays are empty.
/// With a snapshot, rounds begin with one trajectory of every replicate and grow by half of what is done.
/// Throws std::invalid_argument, naming the setting or the receiver, for invalid input.
Result solve(const Scene& scene, const Receivers& receivers, const Settings& settings, const Progress& progress = {},
             const Snapshot& snapshot = {});

/// What one replicate scored at one receiver in a round of trajectories [first, first + count).
struct RoundScores
{
  long long first = 0;
  int count = 0;
  double sum = 0;      ///< lx times trajectories, luminous, with the sampled direct part
  double direct = 0;   ///< lx times trajectories, of it straight from the emitters
  double largest = 0;  ///< largest single score so far, in the same unit
};

struct Replay
{
  int replicates = 0;
  long long trajectories = 0;  ///< of the replicate
  double fixed = 0;            ///< lx, direct light in closed form
  double estimate = 0;         ///< lx: fixed + sums / trajectories; the illuminance is the mean over the replicates
  std::vector<RoundScores> rounds;
};

/// Recomputes one replicate of the solve with these settings, which must have no goal, and returns its scores at one
/// receiver, bitwise equal to those of the solve. Throws std::invalid_argument for input that solve() rejects, for a
/// goal, and for a receiver or replicate that does not exist.
Replay replay(const Scene& scene, const Receivers& receivers, const Settings& settings, std::size_t receiver,
              int replicate);
}  // namespace kalos

#endif
