// SPDX-License-Identifier: BSD-3-Clause
#include "scene/GlossyPlanes.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "scene/Scene.h"

namespace kalos
{
namespace
{
constexpr std::size_t noPlane = std::numeric_limits<std::size_t>::max();

bool contains(const GlossyPlane& plane, const Vec3& p, const Vec3& n, double size)
{
  return length(cross(n, plane.axes.n)) < 1e-9 && std::abs(dot(p - plane.point, plane.axes.n)) < 1e-9 * size;
}

void include(GlossyPlane& plane, const Vec3& p)
{
  const Vec3 local = plane.axes.toLocal(p - plane.point);
  for (const auto& [axis, x] : {std::pair{0, local.x}, {1, local.y}})
  {
    plane.low[axis] = std::min(plane.low[axis], x);
    plane.high[axis] = std::max(plane.high[axis], x);
  }
}
}  // namespace

GlossyPlanes::GlossyPlanes(const Scene& scene)
{
  const auto count = static_cast<std::uint32_t>(scene.data().triangles.size());
  std::vector<GlossyPlane> found;
  std::vector<std::size_t> planeOf(count, noPlane);
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const Brdf* brdf = &scene.brdf(t);
    if (brdf->material().specular == 0)
      continue;
    const Vec3 p = scene.corner(t, 0), n = scene.normal(t);
    // Triangles of one plane follow each other: a longer search would take quadratic time.
    const auto last = found.size() > 64 ? found.rbegin() + 64 : found.rend();
    auto same = std::find_if(found.rbegin(), last, [&](const GlossyPlane& plane) {
      return plane.brdf == brdf && contains(plane, p, n, scene.size());
    });
    if (same == last)
    {
      found.push_back({p, Frame(n), brdf, {}, {}});
      same = found.rbegin();
    }
    for (int i = 0; i < 3; ++i)
      include(*same, scene.corner(t, i));
    same->reflectingArea += scene.area(t) * brdf->material().specular;
    planeOf[t] = static_cast<std::size_t>(found.rend() - same) - 1;
  }
  if (found.empty())
    return;

  // Keep those that reflect most.
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return found[a].reflectingArea > found[b].reflectingArea; });
  order.resize(std::min(order.size(), most));
  std::vector<std::uint8_t> number(found.size(), none);
  for (const std::size_t i : order)
  {
    number[i] = static_cast<std::uint8_t>(this->Planes.size());
    this->Planes.push_back(found[i]);
  }
  this->OfTriangle.resize(count, none);
  for (std::uint32_t t = 0; t < count; ++t)
    if (planeOf[t] != noPlane)
      this->OfTriangle[t] = number[planeOf[t]];
}
}  // namespace kalos
