// SPDX-License-Identifier: BSD-3-Clause
/** The sides of all triangles, those of one edge beside each other. */
#ifndef KalosMeshingSortedSides_h
#define KalosMeshingSortedSides_h

#include <algorithm>
#include <vector>

#include "TriangleMesh.h"

namespace kalos::meshing
{
/** One side of a triangle as an undirected edge. */
struct Side
{
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::uint8_t number;  ///< the side from corner `number` to the next
  bool upwards;         ///< the triangle runs from low to high

  bool sameEdge(const Side& o) const { return this->low == o.low && this->high == o.high; }
};

inline std::vector<Side> sortedSides(const TriangleMesh& mesh)
{
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (std::uint8_t k = 0; k < 3; ++k)
    {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.low != b.low)
      return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
  });
  return sides;
}

/** Calls visit(first, last) for the range of sides of each edge. */
template <typename Visit>
void forEachEdge(const std::vector<Side>& sides, const Visit& visit)
{
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
  {
    while (last < sides.size() && sides[last].sameEdge(sides[first]))
      ++last;
    visit(first, last);
  }
}
}  // namespace kalos::meshing

#endif
