// SPDX-License-Identifier: BSD-3-Clause
// Also known as: systematic resampling of virtual point lights (importance resampling).
//
// Spends shadow rays where they pay: on vertices picked in proportion to their unshadowed scores.
#ifndef kalos_estimator_kernel_VertexResampling_h
#define kalos_estimator_kernel_VertexResampling_h

#include "estimator/kernel/PairKernel.h"
#include "estimator/kernel/PickCount.h"

namespace kalos
{
/// How shadow rays are spent on a tile: `rays` null where nothing can occlude, else at most `picks` (1..mostPicks) of
/// them go to pairs picked in proportion to their luminous scores, systematically from one random number u in [0,1);
/// one to every pair that scores where picks = 0. `counted`: where to count what picks have seen, or null.
struct ShadowPicks
{
  static constexpr int mostPicks = 4 * SegmentPacket::width;

  const RayScene* rays;
  int picks;
  double u;
  PickCount* counted = nullptr;
};

/// An unbiased estimate of formPairs(), keepVisible() and addScores() together, for a tile of count <=
/// VertexTile::capacity vertices. Returns the largest luminous score.
double addResampledScores(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double share,
                          const ShadowPicks& shadows, double* sum);

/// The contribution of a single pick if its target is visible; the caller traces the shadow ray later.
struct ResampledScore
{
  RayAnchor target;
  Bands light;
};

/// Picks by u in [0,1); false when nothing scores. A score that is not finite makes `light` NaN.
bool resampleOne(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double share, double u,
                 ResampledScore& pick);
}  // namespace kalos

#endif
