// SPDX-License-Identifier: BSD-3-Clause
// Also known as: a pilot run that chooses between bidirectional sampling and unidirectional path tracing.
//
// Decides whether vertices help at all. Where luminous surfaces are all around, a path from the receiver meets light at
// every bounce, and the vertices of trajectories only add noise.
#ifndef kalos_estimator_methods_StrategyTrial_h
#define kalos_estimator_methods_StrategyTrial_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
/// Whether paths only (GatherContext::usePathsOnly) take less time than vertices with gather rays to the same error,
/// the same at every receiver. The trial runs at a few receivers with random numbers that no estimate uses, so the
/// choice adds no bias. Time is counted in rays, so the choice is the same on every machine. It runs only where
/// luminous surfaces are at least a tenth of the area, and never with `paths` or `near` disabled.
bool pathsAreBetter(const Scene& scene, const Emission& emission, const Settings& settings,
                    const ReceiverDirectLight& direct);

AuditLine auditPaths();
}  // namespace kalos

#endif
