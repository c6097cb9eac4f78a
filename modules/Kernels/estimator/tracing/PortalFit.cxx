// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/PortalFit.h"

#include <algorithm>
#include <cmath>

#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr std::size_t mostTried = 24;  // segments whose surroundings give planes
constexpr int shakes = 8;              // of each
constexpr double shaken = 0.2;         // of a segment's length
constexpr double leastShare = 0.3;     // of the segments must pass a portal
constexpr double steepest = 0.05;      // cosine to the plane's normal
constexpr double grown = 1.6;          // sides of what is corrected over what was found
constexpr int corrections = 3, probes = 1024;

// A rectangle about points of a plane, a little wider than they are: n uniform points span (n - 1)/(n + 1) of a side.
bool enclose(const std::vector<Vec3>& points, const Vec3& normal, const Vec3& along, Portal& portal)
{
  const Vec3 u = normalized(along - dot(along, normal) * normal), v = cross(normal, u);
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (const Vec3& p : points)
    for (const auto& [k, x] : {std::pair{0, dot(p, u)}, {1, dot(p, v)}})
    {
      low[k] = std::min(low[k], x);
      high[k] = std::max(high[k], x);
    }
  const auto n = static_cast<double>(points.size());
  for (int k = 0; k < 2; ++k)
  {
    const double margin = (high[k] - low[k]) * std::min(0.5, 1.5 / (n - 1));
    low[k] -= margin;
    high[k] += margin;
  }
  portal.u = (high[0] - low[0]) * u;
  portal.v = (high[1] - low[1]) * v;
  portal.corner = dot(points.front(), normal) * normal + low[0] * u + low[1] * v;
  portal.onward = normal;
  portal.area = (high[0] - low[0]) * (high[1] - low[1]);
  return portal.area > 0;
}

// Where a segment passes the plane of a triangle; false beside its ends or along the plane.
bool passes(const Scene& scene, std::uint32_t triangle, const PortalSegment& segment, Vec3& at)
{
  const Vec3& n = scene.normal(triangle);
  const Vec3 d = segment.dark.position - segment.lit.position;
  const double along = dot(d, n);
  if (std::abs(along) < steepest * length(d))
    return false;
  const double t = dot(scene.corner(triangle, 0) - segment.lit.position, n) / along;
  at = segment.lit.position + t * d;
  return t > 1e-3 && t < 1 - 1e-3;
}

// Triangles that hide the dark ends of segments when these are moved a little.
std::vector<std::uint32_t> besideSegments(const Scene& scene, const std::vector<PortalSegment>& segments,
                                          RandomStream& random)
{
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < std::min(segments.size(), mostTried); ++i)
  {
    const PortalSegment& segment = segments[i];
    const Vec3 d = segment.dark.position - segment.lit.position;
    for (int k = 0; k < shakes; ++k)
    {
      const double u1 = random.next(), u2 = random.next();
      const Vec3 to = d + shaken * length(d) * uniformSphere(u1, u2);
      if (!(dot(to, segment.lit.normal) > 0))
        continue;
      const SurfacePoint hit = scene.trace(scene.anchor(segment.lit), normalized(to));
      Vec3 at;
      if (hit.valid && length(hit.position - segment.lit.position) < 0.99 * length(to) &&
          passes(scene, hit.triangle, segment, at))
        found.push_back(hit.triangle);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// The smallest rectangle along an edge of a triangle, about points in its plane.
bool enclose(const Scene& scene, std::uint32_t triangle, const std::vector<Vec3>& points, Portal& portal)
{
  bool any = false;
  for (int edge = 0; edge < 3; ++edge)
  {
    Portal other;
    if (enclose(points, scene.normal(triangle), scene.corner(triangle, (edge + 1) % 3) - scene.corner(triangle, edge),
                other) &&
        (!any || other.area < portal.area))
    {
      portal = other;
      portal.triangle = triangle;
      any = true;
    }
  }
  return any;
}
}  // namespace

bool fitPortal(const Scene& scene, std::vector<PortalSegment>& segments, RandomStream& random, Portal& portal)
{
  double least = 0;  // area over the square of how many pass
  bool any = false;
  for (const std::uint32_t triangle : besideSegments(scene, segments, random))
  {
    std::vector<Vec3> points;
    Vec3 at;
    for (const PortalSegment& segment : segments)
      if (passes(scene, triangle, segment, at))
        points.push_back(at);
    Portal other;
    if (static_cast<double>(points.size()) < leastShare * static_cast<double>(segments.size()) || points.size() < 3 ||
        !enclose(scene, triangle, points, other))
      continue;
    const double cost = other.area / std::pow(static_cast<double>(points.size()), 2);
    if (!any || cost < least)
    {
      portal = other;
      least = cost;
      any = true;
    }
  }
  if (!any)
    return false;
  double forward = 0;
  std::vector<PortalSegment> rest;
  for (const PortalSegment& segment : segments)
  {
    Vec3 at;
    if (passes(scene, portal.triangle, segment, at))
      forward += dot(segment.dark.position - segment.lit.position, portal.onward) > 0 ? 1 : -1;
    else
      rest.push_back(segment);
  }
  if (forward < 0)
    portal.onward = -portal.onward;
  segments = std::move(rest);
  return true;
}

bool correctPortal(const Scene& scene, const std::vector<Vec3>& from, double least, RandomStream& random,
                   Portal& portal)
{
  for (int step = 0; step < corrections; ++step)
  {
    Portal wide = portal;
    wide.corner += -0.5 * (grown - 1) * (portal.u + portal.v);
    wide.u = grown * portal.u;
    wide.v = grown * portal.v;
    std::vector<Vec3> through;
    int tried = 0;
    for (int i = 0; i < probes; ++i)
    {
      const Vec3& p = from[static_cast<std::size_t>(random.next() * static_cast<double>(from.size()))];
      const double s = random.next(), t = random.next();
      const Vec3 q = wide.point(s, t), d = q - p;
      if (!(dot(d, portal.onward) > 0))
        continue;
      ++tried;
      if (!scene.rays().occluded(p, p + (1 + 1e-4) * d))
        through.push_back(q);
    }
    if (through.size() < 4 || static_cast<double>(through.size()) < least * tried)
      return false;
    const Vec3 onward = portal.onward;
    if (!enclose(scene, portal.triangle, through, portal))
      return false;
    portal.onward = onward;
  }
  return true;
}
}  // namespace kalos
