// SPDX-License-Identifier: BSD-3-Clause
// Rejects scores that are NaN, infinite or negative.
#ifndef kalos_estimator_tally_CheckFinite_h
#define kalos_estimator_tally_CheckFinite_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/tally/Tally.h"
#include "scene/Scene.h"

namespace kalos
{
/// After a round of trajectories [first, first + count) of every replicate: throws std::runtime_error when a score was
/// infinite, negative or not a number. The message names receiver and replicate, and the trajectory and vertex that
/// it came from, found by tracing the round of that replicate again.
void checkFinite(const Tally& tally, const Scene& scene, const Receivers& receivers, const Settings& settings,
                 long long first, int count);
}  // namespace kalos

#endif
