// SPDX-License-Identifier: BSD-3-Clause
// Receivers that a solve has left dark: where nothing lit is in sight, 0 lx is more often a mistake than a result.
#ifndef kalos_estimator_quantities_DarkReceivers_h
#define kalos_estimator_quantities_DarkReceivers_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "scene/Scene.h"

namespace kalos
{
/// What there is to say of receivers with 0 lx.
struct DarkReceivers
{
  /// Nothing where no receiver is dark, or nothing in the scene shines; else
  ///
  /// - a line `dark receivers` counts them, and those that have light in sight, which are in full shadow or turned
  /// away;
  /// - a line `warning` counts those that have none in sight and names the first by its number over all sets from 0.
  std::vector<AuditLine> audit;
  /// A flag per receiver: 0 where no light is in sight. Such a receiver is outside of a closed room, below a floor or
  /// inside a solid, and no statistics should count it.
  std::vector<char> valid;
};

/// Dark is what is below 1e-12 of the largest value: arithmetic leaves that much. Light is in sight when a luminaire or
/// an emitting triangle is, or one of them from where a ray from the receiver ends, of 32 about its normal. Of more
/// than 64 emitters so many are looked for, evenly spread.
///
/// Up to 4096 dark receivers are examined so. Of more, 4096 are, evenly spread, and each of the others that one of its
/// two neighbours among these can see has the same answer: no surface is between them.
DarkReceivers findDarkReceivers(const Scene& scene, const Receivers& receivers, const Result& result);
}  // namespace kalos

#endif
