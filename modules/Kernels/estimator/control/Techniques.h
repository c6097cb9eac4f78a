// SPDX-License-Identifier: BSD-3-Clause
// Techniques that make a solve cheaper without bias. Each can be disabled by its name:
//   stratified     walks stratified by Sobol' points (sampling/SampleStream.h), and vertices over space
//                  (estimator/tracing/VertexOrder.h); without: independent numbers
//   picked         shadow rays to vertices picked by their unshadowed scores; without: one to every pair that scores
//   convex         no shadow rays where the audit shows that nothing can occlude
//   near           gather rays only at receivers with a surface near in front
//   paths          no vertices where paths from the receivers win a trial (estimator/methods/StrategyTrial.h)
//   neighbours     gather rays shared by neighbouring receivers (estimator/gathering/ReceiverGroup.h)
//   effort         receivers that reached the goal are skipped (estimator/solve/AdaptiveSampling.h)
//   highlights     light of luminaires by glossy planes sampled about mirror images (estimator/direct/Highlights.h);
//                  without: by vertices and gather rays
//   exact-direct   area emitters by Lambert's polygon formula, sampling only their visibility; without: all sampled,
//                  and emitting meshes by the starts of trajectories
#ifndef kalos_estimator_control_Techniques_h
#define kalos_estimator_control_Techniques_h

#include <string>

#include "estimator/control/Settings.h"

namespace kalos
{
/// Disables the techniques of these names, separated by commas. Throws std::invalid_argument for an unknown name.
void disable(const std::string& names, Settings& settings);

/// The names of the disabled techniques, separated by commas.
std::string disabledTechniques(const Settings& settings);
}  // namespace kalos

#endif
