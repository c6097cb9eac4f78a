// SPDX-License-Identifier: BSD-3-Clause
/** Distances below which points of a mesh are one. */
#ifndef KalosMeshingTolerances_h
#define KalosMeshingTolerances_h

#include <algorithm>

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
/**
 * Merge distance for each point of a mesh, m: a millionth of the diagonal, but at most a ten-thousandth of the shortest
 * edge at the point, and at least the rounding error of its coordinates. Gaps in small objects stay open on a large
 * site, and points that differ by float32 rounding still merge.
 */
class Tolerances
{
public:
  /** `wanted`, m, for all points if it is above 0. */
  Tolerances(const TriangleMesh& mesh, double wanted);

  double largest() const { return Largest; }
  double of(std::uint32_t point) const { return Uniform > 0.0 ? Uniform : Local[point]; }
  double of(std::uint32_t a, std::uint32_t b) const { return std::min(of(a), of(b)); }
  double of(const Triangle& triangle) const { return std::min(of(triangle[0], triangle[1]), of(triangle[2])); }

private:
  double Uniform;
  double Largest;
  std::vector<double> Local;
};
}  // namespace kalos::meshing

#endif
