// SPDX-License-Identifier: BSD-3-Clause
// The parts of a solve, and its rounds: what solve() and replay() share.
#ifndef kalos_estimator_solve_RunningSolve_h
#define kalos_estimator_solve_RunningSolve_h

#include "estimator/solve/Schedule.h"

namespace kalos
{
struct RunningSolve
{
  /// Throws std::invalid_argument, naming the setting or the receiver, for invalid input.
  RunningSolve(const Scene& inScene, const Receivers& atReceivers, const Settings& withSettings,
               const Progress& progress, bool shown);

  /// The work that does not depend on trajectories; false when aborted.
  bool prepare();

  /// Adds a round of `count` trajectories of every replicate; false when aborted.
  bool addRound(int count);

  const Scene& scene;
  const Receivers& receivers;
  const Settings& settings;
  const Ranks oneProcess;
  const Ranks& ranks;
  std::unique_ptr<Estimator> estimator;
  Workers workers;
  Tally tally;
  Schedule schedule;
  long long done = 0;  ///< complete trajectories of every replicate
};
}  // namespace kalos

#endif
