// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RayScene.h"

#include <cstring>
#include <limits>

#include "scene/EmbreeScene.h"
#include "scene/RayCount.h"

namespace kalos
{
namespace
{
// The first `count` segments as rays that end `far` of their lengths away.
void fill(const SegmentPacket& segments, int count, float far, int* valid, RTCRay16& rays)
{
  // Embree with assertions, as in Debian, needs finite numbers in invalid lanes too.
  auto copy = [count](const float* from, float* to) {
    std::fill(std::copy_n(from, count, to), to + SegmentPacket::width, *from);
  };
  copy(segments.ox, rays.org_x);
  copy(segments.oy, rays.org_y);
  copy(segments.oz, rays.org_z);
  copy(segments.dx, rays.dir_x);
  copy(segments.dy, rays.dir_y);
  copy(segments.dz, rays.dir_z);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    valid[i] = i < count ? -1 : 0;
    rays.tnear[i] = 0;
    rays.tfar[i] = far;
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.id[i] = 0;
    rays.flags[i] = 0;
  }
}

// A query that reports every crossing: the filter notes the triangle and rejects the hit, so that traversal goes on.
struct CrossingQuery
{
  embree::QueryContext context;  // first: the filter finds the query at its address
  const std::function<void(std::uint32_t)>* visit;
  std::uint32_t last;  // a triangle in two leaves of the hierarchy is reported twice in a row at most
};

void noteCrossing(const RTCFilterFunctionNArguments* filter)
{
  auto* query = reinterpret_cast<CrossingQuery*>(filter->context);
  const auto triangle = RTCHitN_primID(filter->hit, filter->N, 0);
  if (triangle != query->last)
    (*query->visit)(triangle);
  query->last = triangle;
  filter->valid[0] = 0;
}
}  // namespace

RayScene::RayScene(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
    : Impl(std::make_unique<EmbreeScene>())
{
  this->Impl->build(points, triangles);
}

RayScene::~RayScene() = default;

Hit RayScene::intersect(const RayAnchor& start, const Vec3& direction) const
{
  const Hit hit = this->Impl->first(start, direction);
  // Of the rays aimed at a vertex, 2e-4 slip between its triangles, so a miss is retraced with a slightly perturbed
  // direction.
  if (hit.valid)
    return hit;
  return this->Impl->first(start, direction + 0x1.0p-19 * length(direction) * Frame(normalized(direction)).s);
}

void RayScene::intersect(const SegmentPacket& rays, int count, HitPacket& hits) const
{
  countRays(count);
  alignas(64) int valid[SegmentPacket::width];
  alignas(64) RTCRayHit16 query;
  fill(rays, count, std::numeric_limits<float>::infinity(), valid, query.ray);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.primID[i] = HitPacket::noTriangle;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::traceFirst(this->Impl->scene, valid, query);
  std::memcpy(hits.triangle, query.hit.primID, sizeof hits.triangle);
  std::memcpy(hits.distance, query.ray.tfar, sizeof hits.distance);
  std::memcpy(hits.u, query.hit.u, sizeof hits.u);
  std::memcpy(hits.v, query.hit.v, sizeof hits.v);
}

bool RayScene::occluded(const RayAnchor& a, const RayAnchor& b) const
{
  countRays(1);
  RTCRay ray;
  EmbreeScene::Query query = this->Impl->ask(a, b.point - a.point, &b, ray);
  double distance;
  if (this->Impl->firstNear(query, distance).valid)
    return true;
  embree::traceAny(this->Impl->scene, query.context, EmbreeScene::keepAhead, ray);
  return ray.tfar < 0;
}

std::uint32_t RayScene::occluded(const SegmentPacket& segments, int count) const
{
  countRays(count);
  alignas(64) int valid[SegmentPacket::width];
  alignas(64) RTCRay16 rays;
  fill(segments, count, 1, valid, rays);
  embree::traceAny(this->Impl->scene, valid, rays);
  std::uint32_t mask = 0;
  for (int i = 0; i < count; ++i)
    mask |= (rays.tfar[i] < 0 ? 1u : 0u) << i;
  return mask;
}

void RayScene::crossings(const Vec3& a, const Vec3& b, const std::function<void(std::uint32_t)>& visit) const
{
  countRays(1);
  RTCRayHit hit{};
  hit.ray = makeRay(a, b - a, 1);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  CrossingQuery query{{}, &visit, RTC_INVALID_GEOMETRY_ID};
  embree::traceFirst(this->Impl->scene, query.context, noteCrossing, hit);
}

void RayScene::nearby(const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit) const
{
  EmbreeScene::search(this->Impl->scene, p, radius, visit);
}
}  // namespace kalos
