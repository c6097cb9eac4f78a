// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/EmitterGroups.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kalos
{
namespace
{
constexpr double widest = 0.02;  // of the scene's size
constexpr double decade = 0.5;   // as wide as this share of the scene

// What is compared: whether on a mesh, position over the scene's size, and brightness.
using Features = std::array<double, 5>;

Features featuresOf(const Scene& scene, const Emission& emission, std::size_t i)
{
  const bool onMesh = i >= emission.luminaires();
  Vec3 p;
  double bright = emission.flux(i);
  if (onMesh)
  {
    const std::uint32_t t = emission.triangle(i);
    p = (1.0 / 3) * (scene.corner(t, 0) + scene.corner(t, 1) + scene.corner(t, 2));
    bright = photometric(scene.material(t).exitance, scene.bands());
  }
  else
    p = scene.data().luminaires[i].position;
  const double size = std::max(scene.size(), 1e-30);
  return {onMesh ? 2.0 : 0.0, p.x / size, p.y / size, p.z / size, decade * std::log10(bright)};
}

struct Member
{
  std::size_t emitter;
  Features at;
};
using Group = std::vector<Member>;

struct Extent
{
  int axis = 0;
  double width = 0, middle = 0;
};

Extent extentOf(const Group& group)
{
  Extent found;
  for (int axis = 0; axis < static_cast<int>(Features().size()); ++axis)
  {
    const auto less = [axis](const Member& a, const Member& b) { return a.at[axis] < b.at[axis]; };
    const auto [low, high] = std::minmax_element(group.begin(), group.end(), less);
    const double width = high->at[axis] - low->at[axis];
    if (width > found.width)
      found = {axis, width, (low->at[axis] + high->at[axis]) / 2};
  }
  return found;
}
}  // namespace

EmitterGroups groupEmitters(const Scene& scene, const Emission& emission)
{
  EmitterGroups found;
  found.of.assign(emission.emitters(), -1);
  Group lit;
  for (std::size_t i = 0; i < emission.emitters() - (emission.hasSky() ? 1 : 0); ++i)
    if (emission.flux(i) > 0)
      lit.push_back({i, featuresOf(scene, emission, i)});
  if (lit.empty())
    return found;
  std::vector<Group> groups{lit};
  std::vector<Extent> extents{extentOf(lit)};
  while (groups.size() < EmitterGroups::most)
  {
    const auto largest = std::max_element(extents.begin(), extents.end(),
                                          [](const Extent& a, const Extent& b) { return a.width < b.width; });
    if (!(largest->width > widest))
      break;
    const Extent cut = *largest;
    Group& whole = groups[largest - extents.begin()];
    const auto middle =
        std::stable_partition(whole.begin(), whole.end(), [&](const Member& m) { return m.at[cut.axis] < cut.middle; });
    Group rest(middle, whole.end());
    whole.erase(middle, whole.end());
    *largest = extentOf(whole);
    extents.push_back(extentOf(rest));
    groups.push_back(std::move(rest));
  }
  found.count = static_cast<int>(groups.size());
  for (int g = 0; g < found.count; ++g)
    for (const Member& m : groups[g])
      found.of[m.emitter] = g;
  return found;
}
}  // namespace kalos
