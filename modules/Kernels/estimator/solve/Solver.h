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
}  // namespace kalos

#endif
