// SPDX-License-Identifier: BSD-3-Clause
// Also known as: importance-driven emission (Georgiev et al. 2012; Simon et al. 2017, virtual point light guiding).
//
// Sends trajectories from the luminaires that light the receivers of this solve.
//
// A pilot traces as many trajectories from each group of emitters (EmitterGroups.h) and scores their vertices at some
// of the receivers. With c_rg the share of group g in the indirect light of receiver r, the mean relative variance over
// the receivers is about V = mean over r of sum over g of c_rg^2 / p_g, p_g the share of the trajectories. So p_g is
// the flux-proportional share to a tenth, and in proportion to the root of the mean over r of c_rg^2 otherwise: no
// trajectory weighs more than ten times what it would without. Each half of the pilot judges what the other one found;
// where that does not lower V by a quarter, all stays in proportion to flux.
//
// The pilot's random numbers enter no estimate, and a trajectory carries its flux over its true probability, so
// the choice adds no bias. It depends on the seed, the scene and the receivers, never on threads, ranks or rounds.
#ifndef kalos_estimator_tracing_EmissionPilot_h
#define kalos_estimator_tracing_EmissionPilot_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
/// The emission of a solve.
Emission makeEmission(const Scene& scene, const Receivers& receivers, const Settings& settings);

/// Adds what the pilot chose; nothing where it changed nothing.
void addEmissionAudit(const Emission& emission, std::vector<AuditLine>& lines);
}  // namespace kalos

#endif
