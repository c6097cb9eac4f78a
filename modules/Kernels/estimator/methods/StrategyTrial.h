// SPDX-License-Identifier: BSD-3-Clause
// Whether vertices help at all: where luminous surfaces are all around, a path from the receiver meets its light at
// every bounce, and the vertices of trajectories only add their noise.
#ifndef kalos_estimator_methods_StrategyTrial_h
#define kalos_estimator_methods_StrategyTrial_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
/// Whether paths alone (GatherContext::usePathsOnly) take less time than vertices with gather rays to the same error,
/// the same at every receiver. Tried at a few receivers with random numbers that no estimate uses, so that the choice
/// moves no mean; time is counted in rays, so that it is the same on every machine. Only tried where luminous surfaces
/// are a tenth of all, and never with Settings::alwaysVertices or gatherEverywhere.
bool pathsAreBetter(const Scene& scene, const Emission& emission, const Settings& settings,
                    const ReceiverDirectLight& direct);

AuditLine auditPaths();
}  // namespace kalos

#endif
