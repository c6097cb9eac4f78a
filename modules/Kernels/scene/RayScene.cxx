// SPDX-License-Identifier: BSD-3-Clause
// Supports Embree 3 and 4; no other file of Kalos uses Embree.
#include "scene/RayScene.h"

#if KALOS_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstring>
#include <limits>
#include <stdexcept>

#include "scene/RayCount.h"

namespace kalos
{
namespace
{
// Traversal with a filter that sees every candidate; `context` is what the filter finds in its arguments.
#if KALOS_EMBREE_VERSION >= 4
using QueryContext = RTCRayQueryContext;
constexpr auto filterFlag = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

template <class Arguments>
void setFilter(Arguments& arguments, QueryContext& context, RTCFilterFunctionN filter)
{
  rtcInitRayQueryContext(&context);
  arguments.context = &context;
  arguments.filter = filter;
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
}

void traceFirst(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRayHit& query)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  setFilter(arguments, context, filter);
  rtcIntersect1(scene, &query, &arguments);
}

void traceAny(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  setFilter(arguments, context, filter);
  rtcOccluded1(scene, &ray, &arguments);
}
#else
using QueryContext = RTCIntersectContext;
constexpr auto filterFlag = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

void traceFirst(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRayHit& query)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcIntersect1(scene, &context, &query);
}

void traceAny(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcOccluded1(scene, &context, &ray);
}
#endif

RTCRay makeRay(const Vec3& origin, const Vec3& direction, float far)
{
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0;
  ray.tfar = far;
  ray.mask = -1;
  return ray;
}

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
  QueryContext context;  // first: the filter finds the query at its address
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

void connect(const RayAnchor& from, const AnchorPacket& to, SegmentPacket& segments)
{
  auto single = [](double x) { return static_cast<float>(x); };
  const float px = single(from.point.x), py = single(from.point.y), pz = single(from.point.z);
  const float nx = single(from.normal.x), ny = single(from.normal.y), nz = single(from.normal.z);
  const float base = single(from.base), slope = single(from.slope);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    const float qx = to.px[i], qy = to.py[i], qz = to.pz[i], mx = to.nx[i], my = to.ny[i], mz = to.nz[i];
    const float here = base + slope * (std::abs(nx * qx) + std::abs(ny * qy) + std::abs(nz * qz));
    const float there = to.base[i] + to.slope[i] * (std::abs(mx * px) + std::abs(my * py) + std::abs(mz * pz));
    const float ox = px + here * nx, oy = py + here * ny, oz = pz + here * nz;
    segments.ox[i] = ox;
    segments.oy[i] = oy;
    segments.oz[i] = oz;
    segments.dx[i] = qx + there * mx - ox;
    segments.dy[i] = qy + there * my - oy;
    segments.dz[i] = qz + there * mz - oz;
  }
}

struct RayScene::Embree
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Vec3> points;  // in double precision, for tests that single precision cannot decide
  std::vector<Triangle> triangles;
  double extent = 0;  // m, largest coordinate

  ~Embree()
  {
    if (this->scene)
      rtcReleaseScene(this->scene);
    if (this->device)
      rtcReleaseDevice(this->device);
  }

  // Candidates in single precision, from a little behind the start to a little beyond the end; the filter keeps those
  // between them. Triangles near a crowded end are met in double precision instead, and are no candidates.
  struct Query
  {
    QueryContext context;  // first: the filter finds the query at its address
    const Embree* embree;
    RayAnchor start;
    Vec3 direction;
    const RayAnchor* end;  // null: the ray goes on for ever
    std::vector<std::uint32_t> near;
  };

  Query ask(const RayAnchor& start, const Vec3& direction, const RayAnchor* end, RTCRay& ray) const;
  void addNear(const RayAnchor& anchor, std::vector<std::uint32_t>& near) const;
  bool isBetween(const Query& query, std::uint32_t triangle) const;
  Hit meet(const Query& query, std::uint32_t triangle, double& distance) const;
  Hit firstNear(const Query& query, double& distance) const;
  double distanceTo(const Query& query, std::uint32_t triangle) const;
  Hit first(const RayAnchor& start, const Vec3& direction) const;
  static void keepAhead(const RTCFilterFunctionNArguments* filter);
  static void search(RTCScene scene, const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit);
};

RayScene::Embree::Query RayScene::Embree::ask(const RayAnchor& start, const Vec3& direction, const RayAnchor* end,
                                              RTCRay& ray) const
{
  // More than the error of single precision.
  const double beyond = 0x1.0p-20 * std::max(this->extent, maxAbs(start.point)) / (length(direction) + 1e-30);
  const double far = end ? 1 + 2 * beyond : std::numeric_limits<double>::infinity();
  ray = makeRay(start.point - beyond * direction, direction, static_cast<float>(far));
  Query query{{}, this, start, direction, end, {}};
  this->addNear(start, query.near);
  if (end)
    this->addNear(*end, query.near);
  return query;
}

void RayScene::Embree::addNear(const RayAnchor& anchor, std::vector<std::uint32_t>& near) const
{
  if (!anchor.crowded)
    return;
  search(this->scene, anchor.point, crowd * anchor.lift(), [&](std::uint32_t t) {
    near.push_back(t);
    return true;
  });
}

namespace
{
// Where the anchored end of a ray lies for a triangle of normal n, not of unit length.
Vec3 endFor(const RayAnchor& anchor, const Vec3& n)
{
  constexpr double parallel = 0.998;  // squared cosine: within 2.6 degrees
  const double along = dot(n, anchor.normal);
  return along * along > parallel * dot(n, n) ? anchor.lifted() : anchor.point;
}
}  // namespace

// Whether the plane of a triangle lies between the ends.
bool RayScene::Embree::isBetween(const Query& query, std::uint32_t triangle) const
{
  const Triangle& t = this->triangles[triangle];
  const Vec3 a = this->points[t[0]], n = cross(this->points[t[1]] - a, this->points[t[2]] - a);
  const double side = dot(n, endFor(query.start, n) - a);
  const double towards = dot(n, query.end ? endFor(*query.end, n) - a : query.direction);
  return side * towards < 0;
}

// Along the ray to the plane of a triangle, in lengths of its direction.
double RayScene::Embree::distanceTo(const Query& query, std::uint32_t triangle) const
{
  const Triangle& t = this->triangles[triangle];
  const Vec3 a = this->points[t[0]], n = cross(this->points[t[1]] - a, this->points[t[2]] - a);
  return -dot(n, query.start.point - a) / dot(n, query.direction);
}

Hit RayScene::Embree::meet(const Query& query, std::uint32_t triangle, double& distance) const
{
  if (!this->isBetween(query, triangle))
    return {};
  const Triangle& t = this->triangles[triangle];
  const Vec3 a = this->points[t[0]], u = this->points[t[1]] - a, v = this->points[t[2]] - a, n = cross(u, v);
  distance = this->distanceTo(query, triangle);
  const Vec3 p = query.start.point + distance * query.direction - a;
  const double square = dot(n, n), atU = dot(cross(p, v), n) / square, atV = dot(cross(u, p), n) / square;
  return {atU >= 0 && atV >= 0 && atU + atV <= 1, triangle, atU, atV};
}

Hit RayScene::Embree::firstNear(const Query& query, double& distance) const
{
  Hit first;
  distance = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : query.near)
  {
    double there;
    const Hit hit = this->meet(query, t, there);
    if (!hit.valid || !(there < distance))
      continue;
    first = hit;
    distance = there;
  }
  return first;
}

void RayScene::Embree::keepAhead(const RTCFilterFunctionNArguments* filter)
{
  const auto& query = *reinterpret_cast<const Query*>(filter->context);
  const std::uint32_t t = RTCHitN_primID(filter->hit, filter->N, 0);
  if (std::find(query.near.begin(), query.near.end(), t) != query.near.end() || !query.embree->isBetween(query, t))
    filter->valid[0] = 0;
}

RayScene::RayScene(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
    : Impl(std::make_unique<Embree>())
{
  Embree& e = *this->Impl;
  e.device = rtcNewDevice(nullptr);
  if (!e.device)
    throw std::runtime_error("Embree cannot start on this processor");
  e.scene = rtcNewScene(e.device);
  // Robust mode: no leaks through shared edges.
  rtcSetSceneFlags(e.scene, RTC_SCENE_FLAG_ROBUST | filterFlag);
  e.points = points;
  e.triangles = triangles;
  for (const Vec3& p : points)
    e.extent = std::max(e.extent, maxAbs(p));

  if (!triangles.empty())
  {
    RTCGeometry geometry = rtcNewGeometry(e.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), points.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), triangles.size()));
    if (!vertices || !indices)
    {
      rtcReleaseGeometry(geometry);
      throw std::runtime_error("Not enough memory for the ray scene of " + std::to_string(triangles.size()) +
                               " triangles");
    }
    for (const Vec3& p : points)
    {
      *vertices++ = static_cast<float>(p.x);
      *vertices++ = static_cast<float>(p.y);
      *vertices++ = static_cast<float>(p.z);
    }
    std::memcpy(indices, triangles.data(), triangles.size() * sizeof(Triangle));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(e.scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(e.scene);
  if (rtcGetDeviceError(e.device) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the ray scene of " + std::to_string(triangles.size()) + " triangles");
}

RayScene::~RayScene() = default;

Hit RayScene::Embree::first(const RayAnchor& start, const Vec3& direction) const
{
  countRays(1);
  RTCRayHit hit{};
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query = this->ask(start, direction, nullptr, hit.ray);
  double distance;
  const Hit near = this->firstNear(query, distance);
  traceFirst(this->scene, query.context, keepAhead, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID || (near.valid && distance < this->distanceTo(query, hit.hit.primID)))
    return near;
  return {true, hit.hit.primID, hit.hit.u, hit.hit.v};
}

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
#if KALOS_EMBREE_VERSION >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  rtcIntersect16(valid, this->Impl->scene, &query, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect16(valid, this->Impl->scene, &context, &query);
#endif
  std::memcpy(hits.triangle, query.hit.primID, sizeof hits.triangle);
  std::memcpy(hits.distance, query.ray.tfar, sizeof hits.distance);
  std::memcpy(hits.u, query.hit.u, sizeof hits.u);
  std::memcpy(hits.v, query.hit.v, sizeof hits.v);
}

bool RayScene::occluded(const RayAnchor& a, const RayAnchor& b) const
{
  countRays(1);
  RTCRay ray;
  Embree::Query query = this->Impl->ask(a, b.point - a.point, &b, ray);
  double distance;
  if (this->Impl->firstNear(query, distance).valid)
    return true;
  traceAny(this->Impl->scene, query.context, Embree::keepAhead, ray);
  return ray.tfar < 0;
}

std::uint32_t RayScene::occluded(const SegmentPacket& segments, int count) const
{
  countRays(count);
  alignas(64) int valid[SegmentPacket::width];
  alignas(64) RTCRay16 rays;
  fill(segments, count, 1, valid, rays);
#if KALOS_EMBREE_VERSION >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcOccluded16(valid, this->Impl->scene, &rays, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, this->Impl->scene, &context, &rays);
#endif
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
  traceFirst(this->Impl->scene, query.context, noteCrossing, hit);
}

void RayScene::nearby(const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit) const
{
  Embree::search(this->Impl->scene, p, radius, visit);
}

void RayScene::Embree::search(RTCScene scene, const Vec3& p, double radius,
                              const std::function<bool(std::uint32_t)>& visit)
{
  RTCPointQuery query{};
  query.x = static_cast<float>(p.x);
  query.y = static_cast<float>(p.y);
  query.z = static_cast<float>(p.z);
  query.radius = static_cast<float>(radius);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  auto note = [](RTCPointQueryFunctionArguments* found) {
    const bool goOn = (*static_cast<const std::function<bool(std::uint32_t)>*>(found->userPtr))(found->primID);
    if (!goOn)
      found->query->radius = 0;
    return !goOn;  // whether the radius changed
  };
  rtcPointQuery(scene, &query, &context, note,
                const_cast<void*>(static_cast<const void*>(&visit)));  // Embree's user pointer is not const
}
}  // namespace kalos
