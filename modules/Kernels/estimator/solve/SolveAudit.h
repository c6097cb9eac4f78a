// SPDX-License-Identifier: BSD-3-Clause
// Lines of the audit that hold for every method.
#ifndef kalos_estimator_solve_SolveAudit_h
#define kalos_estimator_solve_SolveAudit_h

#include <vector>

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
/// Bands, and how the materials reflect.
std::vector<AuditLine> auditMaterials(const Scene& scene);

/// How many receivers have met the goal for the error.
AuditLine auditGoal(const Settings& settings, const Result& result);

AuditLine auditRanks(int processes, int replicates);
AuditLine auditStop(const Result& result);
}  // namespace kalos

#endif
