// SPDX-License-Identifier: BSD-3-Clause
// Receivers that a solve has left dark: where nothing lit is in sight, 0 lx is more often a mistake than a result.
#ifndef kalos_estimator_DarkReceivers_h
#define kalos_estimator_DarkReceivers_h

#include "estimator/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
/// What there is to say of receivers with 0 lx; nothing where none has, or nothing in the scene shines:
///
/// - a line `dark receivers` counts them, and those that have light in sight, which are in full shadow or turned away;
/// - a line `warning` counts those that have none in sight, names the first by its number over all sets from 0 and says
///   where it lies: outside of a closed room, below a floor or inside a solid.
///
/// Dark is what is below 1e-12 of the largest value: arithmetic leaves that much. Light is in sight when a luminaire or
/// an emitting triangle is, or one of them from where a ray from the receiver ends, of 32 about its normal. Of more
/// than 4096 dark receivers so many are looked at, evenly spread, and of more than 64 emitters likewise.
std::vector<AuditLine> auditDarkReceivers(const Scene& scene, const Receivers& receivers, const Result& result);
}  // namespace kalos

#endif
