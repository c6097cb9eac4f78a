// SPDX-License-Identifier: BSD-3-Clause
// What a solve finds out about the sky before it starts.
#ifndef kalos_estimator_solve_Daylight_h
#define kalos_estimator_solve_Daylight_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "scene/SkyOpenings.h"

namespace kalos
{
/// The openings through which the sky's light may reach the receivers.
SkyOpenings findOpenings(const Scene& scene, const Receivers& receivers, const Settings& settings);

/// The lines about sky and openings; a warning when none of the sky is in sight of the receivers, not even by
/// reflections.
std::vector<AuditLine> auditDaylight(const Scene& scene, const SkyOpenings& openings);
}  // namespace kalos

#endif
