// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/SpatialOrder.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace kalos
{
namespace
{
// The bits of a number below 2^20 with two zeros before each.
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t axisOf(const Vec3& n)
{
  const int axis = mainAxis(n);
  return 2 * static_cast<std::uint64_t>(axis) + ((axis == 0 ? n.x : axis == 1 ? n.y : n.z) < 0 ? 1 : 0);
}
}  // namespace

std::vector<std::size_t> spatialOrder(const std::vector<Vec3>& points, const std::vector<Vec3>& normals)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), steps = (1 << 20) - 1;
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (const Vec3& p : points)
  {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double extent = maxAbs(high - low), scale = extent > 0 ? steps / extent : 0;
  std::vector<std::uint64_t> key;
  key.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3 p = scale * (points[i] - low);
    auto along = [](double x) { return spread(static_cast<std::uint64_t>(x)); };
    key.push_back(axisOf(normals[i]) << 60 | along(p.x) | along(p.y) << 1 | along(p.z) << 2);
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  return order;
}
}  // namespace kalos
