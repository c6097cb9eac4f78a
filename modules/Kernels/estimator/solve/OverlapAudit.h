// SPDX-License-Identifier: BSD-3-Clause
// Tells of faces that lie in one place.
#ifndef kalos_estimator_solve_OverlapAudit_h
#define kalos_estimator_solve_OverlapAudit_h

#include "estimator/control/Result.h"
#include "scene/Scene.h"

namespace kalos
{
/// One line for each pair of surfaces and materials that overlap: which lies on top, over what area. A warning where a
/// face is hidden, and where two are back to back unless one of them encloses that side, as a box does that stands on a
/// floor. Of many pairs the largest are named and the others counted.
std::vector<AuditLine> auditOverlaps(const Scene& scene);
}  // namespace kalos

#endif
