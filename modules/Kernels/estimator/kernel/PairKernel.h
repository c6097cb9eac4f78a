// SPDX-License-Identifier: BSD-3-Clause
// The geometric kernel G = cos(theta) cos(theta') / (pi d^2), 1/m2 (E3), of sensors against vertices, and its scores.
#ifndef kalos_estimator_kernel_PairKernel_h
#define kalos_estimator_kernel_PairKernel_h

#include "estimator/kernel/Sensor.h"
#include "estimator/kernel/VectorKernel.h"

namespace kalos
{
/// A run of vertices paired with one sensor. Holds only pairs that score.
struct PairBlock
{
  static constexpr int capacity = VertexTile::capacity;
  int count = 0;
  int index[capacity];         ///< of the vertex in its set
  float kernel[capacity];      ///< 1/m2, what the method scores: a(G) G, or an altered kernel
  float plain[capacity] = {};  ///< 1/m2, G; only filled for methods that alter the kernel
  std::vector<Bands> factor;   ///< BRDF factors per band; empty where vertex and sensor are Lambertian
};

/// Fills `block` with the pairs that score among vertices [begin, begin + count), count <= PairBlock::capacity:
/// kernel = G / (1 + f^ G/G*), with G* = vertex density / share, where `share` is the number of gather rays per
/// trajectory (0: the plain kernel) and f^ the lobe ratio of a glossy vertex.
void formPairs(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double share,
               PairBlock& block);

/// The same with the plain kernel, but keeps every vertex nearer than `reach` (m), also where G = 0, and fills
/// PairBlock::plain.
void formNearPairs(const VertexSet& vertices, std::size_t begin, int count, const Sensor& sensor, double reach,
                   PairBlock& block);

/// Removes occluded pairs, by one shadow ray each in packets of sixteen.
void keepVisible(const RayScene& rays, const VertexSet& vertices, const Sensor& sensor, PairBlock& block);

/// Segments from the sensor to the `count` <= 16 vertices of these indices; idle lanes repeat the last one.
void fillPacket(const VertexSet& vertices, const Sensor& sensor, const int* indices, int count, SegmentPacket& packet);

/// Luminous score of pair i, lx times the number of trajectories.
double luminousScore(const VertexSet& vertices, const PairBlock& block, int i);

/// Adds flux times kernel of every pair to sum[0..bands). Returns the largest luminous score.
double addScores(const VertexSet& vertices, const PairBlock& block, double* sum);
}  // namespace kalos

#endif
