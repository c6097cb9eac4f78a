// SPDX-License-Identifier: BSD-3-Clause
// The geometric kernel G = cos(theta) cos(theta') / (pi d^2), 1/m2 (E3), of receivers against vertices.
#ifndef kalos_estimator_PairKernel_h
#define kalos_estimator_PairKernel_h

#include "estimator/Trajectories.h"

namespace kalos
{
/// A receiver as the pair kernels see it: single precision, about the scene's origin.
struct ReceiverPoint
{
  Vec3 position, normal;  ///< about the scene's origin
  Vec3 rayOrigin;         ///< moved off the surface it may lie on

  ReceiverPoint(const Scene& scene, const Vec3& world, const Vec3& unitNormal)
      : position(world - scene.origin()), normal(unitNormal), rayOrigin(scene.offset(position, unitNormal))
  {
  }
};

/// A run of vertices paired with one receiver; only those that score are kept.
struct PairBlock
{
  static constexpr int capacity = 256;
  int count = 0;
  int index[capacity];  ///< of the vertex in its set
  float g[capacity];    ///< G of that pair
};

/// Fills `block` with the pairs of G > 0 among vertices [begin, begin + count), count <= PairBlock::capacity.
/// About two instructions per pair and lane; compiled for AVX-512, AVX2 and SSE2, chosen at run time.
void formPairs(const VertexSet& vertices, std::size_t begin, int count, const ReceiverPoint& receiver,
               PairBlock& block);

/// Removes the pairs that do not see each other: one shadow ray each, in packets of sixteen.
void keepVisible(const RayScene& rays, const VertexSet& vertices, const ReceiverPoint& receiver, PairBlock& block);
}  // namespace kalos

#endif
