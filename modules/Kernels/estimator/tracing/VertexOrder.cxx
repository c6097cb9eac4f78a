// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/VertexOrder.h"

#include <algorithm>
#include <numeric>

#include "estimator/kernel/VectorKernel.h"

namespace kalos
{
namespace
{
constexpr int lanes = VertexTile::lanes;

// Vertices that lanes [first, last) of a tile of `count` hold.
int heldBy(int first, int last, int count)
{
  int held = 0;
  for (int lane = first; lane < last; ++lane)
    held += (count - lane + lanes - 1) / lanes;
  return held;
}

// Coordinates along the longest side of the box of some vertices.
const std::vector<float>& longestSide(const VertexSet& set, const std::size_t* begin, const std::size_t* end)
{
  const std::vector<float>* longest = nullptr;
  float most = -1;
  for (const std::vector<float>* side : {&set.px, &set.py, &set.pz})
  {
    float low = (*side)[*begin], high = low;
    for (const std::size_t* i = begin; i < end; ++i)
    {
      low = std::min(low, (*side)[*i]);
      high = std::max(high, (*side)[*i]);
    }
    if (high - low > most)
    {
      most = high - low;
      longest = side;
    }
  }
  return *longest;
}

// Puts the vertices that begin at `begin`, of lanes [first, last) of a tile of `count`, lane after lane.
void divide(const VertexSet& set, int count, int first, int last, std::size_t* begin)
{
  std::size_t* end = begin + heldBy(first, last, count);
  if (last - first == 1 || end - begin < 2)
    return std::sort(begin, end);
  const int middle = (first + last) / 2;
  std::size_t* split = begin + heldBy(first, middle, count);
  const std::vector<float>& x = longestSide(set, begin, end);
  // Break ties, so that every standard library divides alike.
  std::nth_element(begin, split, end,
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b] || (!(x[b] < x[a]) && a < b); });
  divide(set, count, first, middle, begin);
  divide(set, count, middle, last, split);
}
}  // namespace

void separateStrata(VertexSet& set)
{
  std::vector<std::size_t> order(set.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return set.stratum[a] < set.stratum[b]; });
  set.reorder(order);
  set.strataEnds.clear();
  for (std::size_t i = 1; i <= set.size(); ++i)
    if (i == set.size() || set.stratum[i] != set.stratum[i - 1])
      set.strataEnds.push_back(i);
}

void spreadOverLanes(VertexSet& set)
{
  std::vector<std::size_t> order(set.size()), tile;
  forEachTile(set, [&](std::size_t begin, int count) {
    tile.resize(count);
    std::iota(tile.begin(), tile.end(), begin);
    divide(set, count, 0, lanes, tile.data());
    const std::size_t* next = tile.data();
    for (int lane = 0; lane < lanes; ++lane)
      for (int i = lane; i < count; i += lanes)
        order[begin + i] = *next++;
  });
  set.reorder(order);
}
}  // namespace kalos
