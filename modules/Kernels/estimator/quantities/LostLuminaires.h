// SPDX-License-Identifier: BSD-3-Clause
// Finds luminaires whose light gets to no receiver: above the ceiling, in a closed housing, outside of the room.
#ifndef kalos_estimator_quantities_LostLuminaires_h
#define kalos_estimator_quantities_LostLuminaires_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "scene/Scene.h"

namespace kalos
{
/// A warning for each luminaire from which no receiver is reached: not straight, and not from where 32 of its rays end
/// or, by one more ray from each, have ended after up to four reflections. It names the luminaire and what most of its
/// rays end on. Of more than 64 receivers 64 evenly spread ones are tested: the valid ones; where none is, those in a
/// room, from which all rays end on the front of surfaces; else the receivers are to blame. After eight such luminaires
/// the search ends.
std::vector<AuditLine> findLostLuminaires(const Scene& scene, const Receivers& receivers,
                                          const std::vector<char>& valid);
}  // namespace kalos

#endif
