// SPDX-License-Identifier: BSD-3-Clause
// A run of light vertices that is scored at once.
#ifndef kalos_estimator_tracing_VertexTile_h
#define kalos_estimator_tracing_VertexTile_h

#include "estimator/tracing/VertexSet.h"

namespace kalos
{
/// Vertices [begin, begin + count) of a set, count <= capacity, paired with one sensor.
struct VertexTile
{
  static constexpr int capacity = 512;  ///< enough to hide the cost of a call
  static constexpr int lanes = 16;      ///< vertices that are scored side by side

  const VertexSet& vertices;
  std::size_t begin;
  int count;

  int paddedCount() const { return (this->count + lanes - 1) / lanes * lanes; }
};

/// Calls visit(begin, count) for every tile of a set; no tile has vertices of two strata.
template <class Visit>
void forEachTile(const VertexSet& v, const Visit& visit)
{
  for (std::size_t s = 0; s < v.strata(); ++s)
    for (std::size_t begin = v.stratumBegin(s), end = v.stratumEnd(s); begin < end; begin += VertexTile::capacity)
      visit(begin, static_cast<int>(std::min<std::size_t>(VertexTile::capacity, end - begin)));
}
}  // namespace kalos

#endif
