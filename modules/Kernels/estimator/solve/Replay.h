// SPDX-License-Identifier: BSD-3-Clause
// Recomputes one of the independent replicates behind a value.
#ifndef kalos_estimator_solve_Replay_h
#define kalos_estimator_solve_Replay_h

#include <vector>

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
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
