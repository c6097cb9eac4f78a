// SPDX-License-Identifier: BSD-3-Clause
// What makes a solve cheaper without moving its mean, each with a name by which it can be switched off:
//   stratified     walks stratified by Sobol' points (sampling/SampleStream.h), and vertices over space
//                  (estimator/tracing/VertexOrder.h); without: independent numbers
//   picked         shadow rays to vertices picked by their unshadowed scores; without: one to every pair that scores
//   convex         no shadow rays where the audit shows that nothing can occlude
//   near           gather rays only at receivers with a surface near in front
//   paths          no vertices where paths from the receivers alone win a trial (estimator/methods/StrategyTrial.h)
//   neighbours     gather rays shared by receivers beside each other (estimator/gathering/ReceiverGroup.h)
//   effort         receivers that have enough for the goal rest (estimator/solve/AdaptiveSampling.h)
//   exact-direct   area emitters by Lambert's polygon formula, only what hides them sampled; without: all sampled, and
//                  emitting meshes by the starts of trajectories
#ifndef kalos_estimator_control_Techniques_h
#define kalos_estimator_control_Techniques_h

#include <string>

#include "estimator/control/Settings.h"

namespace kalos
{
/// Switches off the savings of these names, separated by commas. Throws std::invalid_argument for a name that is none.
void disable(const std::string& names, Settings& settings);

/// The names of the savings that are switched off, separated by commas.
std::string disabledTechniques(const Settings& settings);
}  // namespace kalos

#endif
