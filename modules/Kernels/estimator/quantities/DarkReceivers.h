// SPDX-License-Identifier: BSD-3-Clause
// Finds receivers with 0 lx. Where nothing lit is in sight, 0 lx is more often a mistake in the model than a result.
#ifndef kalos_estimator_quantities_DarkReceivers_h
#define kalos_estimator_quantities_DarkReceivers_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "scene/Scene.h"

namespace kalos
{
/// Audit and flags of receivers with 0 lx.
struct DarkReceivers
{
  /// Empty where no receiver is dark, or nothing in the scene shines; else
  ///
  /// - a line `dark receivers` counts them, and those that have light in sight, which are in full shadow or turned
  /// away;
  /// - a line `warning` counts those that have none in sight and names the first by its number over all sets from 0.
  std::vector<AuditLine> audit;
  /// A flag per receiver: 0 where no light is in sight. Such a receiver is outside of a closed room, below a floor or
  /// inside a solid, and no statistics should count it.
  std::vector<char> valid;
};

/// A value below 1e-12 of the largest counts as dark: that is the rounding error. Light is in sight when a luminaire or
/// an emitting triangle is, or one of them is visible from the end of one of 32 rays from the receiver. Of more than 64
/// emitters, 64 evenly spread ones are tested.
///
/// At most 4096 dark receivers are examined, evenly spread. Each of the others takes the answer of the nearest examined
/// one before or after it that it can see.
DarkReceivers findDarkReceivers(const Scene& scene, const Receivers& receivers, const Result& result);
}  // namespace kalos

#endif
