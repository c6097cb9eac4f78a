// SPDX-License-Identifier: BSD-3-Clause
// Emitters that a pilot treats alike: they are near each other and about as bright.
#ifndef kalos_estimator_tracing_EmitterGroups_h
#define kalos_estimator_tracing_EmitterGroups_h

#include "estimator/tracing/Emission.h"

namespace kalos
{
struct EmitterGroups
{
  static constexpr int most = 64;

  std::vector<int> of;  ///< the group of each emitter of an Emission; -1 without flux
  int count = 0;
};

/// Halves groups, the widest first, until none is wider than a fiftieth of the scene and a twenty-fifth of a decade
/// of brightness, or there are EmitterGroups::most. Brightness is the flux of a luminaire and the exitance of a
/// triangle; no group has both.
EmitterGroups groupEmitters(const Scene& scene, const Emission& emission);
}  // namespace kalos

#endif
