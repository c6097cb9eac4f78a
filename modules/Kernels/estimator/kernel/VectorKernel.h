// SPDX-License-Identifier: BSD-3-Clause
// The geometric kernel of a Lambertian sensor against a tile of Lambertian vertices, in vector code (Highway) for SSE4,
// AVX2, AVX-512 and the other targets of Highway, chosen at run time.
//
// Rate: 1.7e9 pairs a second on one core of an AMD EPYC (Zen 3, 2.6 GHz, AVX2), as `KernelBenchmarks
// --benchmark_filter=UnshadowedPairs` prints. Single precision, an exact division and no square root, no fused
// multiply-add: every instruction set gives the same bits. Four sensors at once against the same vertices, or an
// approximate reciprocal with a Newton step, were not faster.
//
// Error: the sensor's position is split into two single-precision numbers, so that distances are as good as those of
// the vertices given, down to d = 1e-7 m: |kernel - G| <= 1e-6 / (pi d^2).
#ifndef kalos_estimator_kernel_VectorKernel_h
#define kalos_estimator_kernel_VectorKernel_h

#include "estimator/kernel/Sensor.h"
#include "estimator/tracing/VertexTile.h"

namespace kalos
{
/// kernel[i] = G / (1 + G/G*), 1/m2, 0 where one of the two faces away; paddedCount() values.
void evaluateKernels(const VertexTile& tile, const Sensor& sensor, double share, float* kernel);

/// Luminous scores, lx times trajectories, as they add up along the lanes.
struct TileScores
{
  alignas(64) float reached[VertexTile::capacity];  ///< by vertex i: the sum of the scores of i, i - lanes, i - 2
                                                    ///< lanes, ...
  int count;                                        ///< the tile's paddedCount()
  float largest;                                    ///< single score

  float laneSum(int lane) const { return this->reached[this->count - VertexTile::lanes + lane]; }
  double total() const
  {
    double sum = 0;
    for (int lane = 0; lane < VertexTile::lanes; ++lane)
      sum += static_cast<double>(this->laneSum(lane));
    return sum;
  }
};
void scoreTile(const VertexTile& tile, const Sensor& sensor, double share, TileScores& scores);
}  // namespace kalos

#endif
