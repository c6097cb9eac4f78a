// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/RegionMap.h"

#include <algorithm>
#include <cmath>

namespace kalos
{
namespace
{
constexpr std::size_t keptPoints = 4;  // of each kind and region

double coordinate(const Vec3& p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}
}  // namespace

RegionMap::RegionMap(Points points, std::ptrdiff_t largestRegion) : Largest(largestRegion)
{
  double light = 0, importance = 0;
  for (const Point& p : points)
    (p.fromReceivers ? importance : light) += 1;
  const double perLight = importance / std::max(1.0, light);
  auto begin = points.begin();
  for (int side = 0; side < 6; ++side)
  {
    const auto end =
        std::stable_partition(begin, points.end(), [side](const Point& p) { return mainDirection(p.normal) == side; });
    if (end != begin)
      this->Roots[side] = this->build(begin, end, perLight);
    begin = end;
  }
}

int RegionMap::build(Points::iterator begin, Points::iterator end, double perLight)
{
  const int node = static_cast<int>(this->Nodes.size());
  this->Nodes.emplace_back();
  Vec3 low = begin->position, high = low;
  for (auto p = begin; p != end; ++p)
  {
    low = {std::min(low.x, p->position.x), std::min(low.y, p->position.y), std::min(low.z, p->position.z)};
    high = {std::max(high.x, p->position.x), std::max(high.y, p->position.y), std::max(high.z, p->position.z)};
  }
  const Vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (end - begin <= this->Largest || !(coordinate(size, axis) > 0))
  {
    const auto importance =
        static_cast<double>(std::count_if(begin, end, [](const Point& p) { return p.fromReceivers; }));
    const double light = static_cast<double>(end - begin) - importance;
    Region region;
    region.contrast = std::log((importance + 0.5) / (light * perLight + 0.5));
    std::size_t kept[2] = {};
    for (auto p = begin; p != end; ++p)
      if (kept[p->fromReceivers]++ < keptPoints)
        region.some.push_back(*p);
    const int index = static_cast<int>(this->Regions.size());
    this->Regions.push_back(std::move(region));
    this->Nodes[node] = {none, index, index, 0};
    return node;
  }
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [axis](const Point& a, const Point& b) {
    return coordinate(a.position, axis) < coordinate(b.position, axis);
  });
  const double at = coordinate(middle->position, axis);
  const int lower = this->build(begin, middle, perLight), higher = this->build(middle, end, perLight);
  this->Nodes[node] = {axis, lower, higher, at};
  return node;
}

int RegionMap::find(const Vec3& p, const Vec3& n) const
{
  int node = this->Roots[mainDirection(n)];
  if (node == none)
    return none;
  while (this->Nodes[node].axis != none)
  {
    const Node& split = this->Nodes[node];
    node = coordinate(p, split.axis) < split.at ? split.low : split.high;
  }
  return this->Nodes[node].low;
}

double RegionMap::contrast(const Vec3& p, const Vec3& n) const
{
  const int region = this->find(p, n);
  return region == none ? 0 : this->Regions[static_cast<std::size_t>(region)].contrast;
}
}  // namespace kalos
