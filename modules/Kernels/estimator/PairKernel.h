// SPDX-License-Identifier: BSD-3-Clause
// The geometric kernel G = cos(theta) cos(theta') / (pi d^2), 1/m2 (E3), of sensors against vertices, and its scores.
#ifndef kalos_estimator_PairKernel_h
#define kalos_estimator_PairKernel_h

#include "estimator/Sensor.h"
#include "estimator/VertexSet.h"

namespace kalos
{
/// A run of vertices paired with one sensor; only those that score are kept.
struct PairBlock
{
  static constexpr int capacity = 128;
  int count = 0;
  int index[capacity];         ///< of the vertex in its set
  float kernel[capacity];      ///< 1/m2, what the method scores: a(G) G, or an altered kernel
  float plain[capacity] = {};  ///< 1/m2, G; only filled for methods that alter the kernel
  std::vector<Bands> factor;   ///< BRDF factors per band; empty where vertex and sensor are Lambertian
};

/// Fills `block` with the pairs that score among vertices [begin, begin + count), count <= PairBlock::capacity:
/// kernel = G / (1 + f^ G/G*), with G* = vertex density / share, where `share` is the number of gather rays per
/// trajectory (0: the plain kernel) and f^ the lobe ratio of a glossy vertex. The Lambertian case is vector code for
/// AVX-512, AVX2 and SSE2, chosen at run time.
void formPairs(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double share,
               PairBlock& block);

/// The same with the plain kernel, but keeps every vertex nearer than `reach` (m), also where G = 0, and fills
/// PairBlock::plain.
void formNearPairs(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double reach,
                   PairBlock& block);

/// Removes the pairs that do not see each other: one shadow ray each, in packets of sixteen.
void keepVisible(const RayScene& rays, const VertexSet& vertices, const Sensor& sensor, PairBlock& block);

/// Adds flux times kernel of every pair to sum[0..bands). Returns the largest luminous score.
double addScores(const VertexSet& vertices, const PairBlock& block, double* sum);

/// How shadow rays are spent on a block: `rays` null where nothing can occlude, else at most `picks` (1..16) of them go
/// to pairs picked in proportion to their luminous scores, systematically from one random number u in [0,1).
struct ShadowPicks
{
  const RayScene* rays;
  int picks;
  double u;
};

/// An unbiased estimate of formPairs(), keepVisible() and addScores() together. Returns the largest luminous score.
double addPickedScores(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double share,
                       const ShadowPicks& shadows, double* sum);
}  // namespace kalos

#endif
