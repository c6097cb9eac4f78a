// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/VertexOrder.h"

#include <algorithm>
#include <numeric>

#include "estimator/VectorKernel.h"

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
  // Equal coordinates are told apart, so that every library divides alike.
  std::nth_element(begin, split, end,
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b] || (!(x[b] < x[a]) && a < b); });
  divide(set, count, first, middle, begin);
  divide(set, count, middle, last, split);
}

template <class T>
void reorder(const std::vector<std::size_t>& order, std::vector<T>& values)
{
  if (values.empty())  // what only glossy vertices have
    return;
  std::vector<T> reordered;
  reordered.reserve(values.size());
  for (const std::size_t i : order)
    reordered.push_back(values[i]);
  values.swap(reordered);
}
}  // namespace

void spreadOverLanes(VertexSet& set)
{
  std::vector<std::size_t> order(set.size()), tile;
  for (std::size_t begin = 0; begin < set.size(); begin += VertexTile::capacity)
  {
    const auto count = static_cast<int>(std::min<std::size_t>(VertexTile::capacity, set.size() - begin));
    tile.resize(count);
    std::iota(tile.begin(), tile.end(), begin);
    divide(set, count, 0, lanes, tile.data());
    const std::size_t* next = tile.data();
    for (int lane = 0; lane < lanes; ++lane)
      for (int i = lane; i < count; i += lanes)
        order[begin + i] = *next++;
  }
  for (std::vector<float>* values :
       {&set.px, &set.py, &set.pz, &set.nx, &set.ny, &set.nz, &set.offset, &set.inverseDensity, &set.luminous})
    reorder(order, *values);
  for (std::vector<float>& band : set.flux)
    reorder(order, band);
  reorder(order, set.brdf);
  reorder(order, set.incident);
}
}  // namespace kalos
