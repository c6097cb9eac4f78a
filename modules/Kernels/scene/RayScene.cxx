// SPDX-License-Identifier: BSD-3-Clause
// Embree 3 and 4, and nothing else of Kalos knows them.
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
#if KALOS_EMBREE_VERSION >= 4
using QueryArguments = RTCIntersectArguments;
using OcclusionArguments = RTCOccludedArguments;
constexpr auto filterFlag = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
#else
using QueryArguments = RTCIntersectContext;
using OcclusionArguments = RTCIntersectContext;
constexpr auto filterFlag = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
#endif

void initialise(QueryArguments& arguments)
{
#if KALOS_EMBREE_VERSION >= 4
  rtcInitIntersectArguments(&arguments);
#else
  rtcInitIntersectContext(&arguments);
#endif
}

#if KALOS_EMBREE_VERSION >= 4
void initialise(OcclusionArguments& arguments)
{
  rtcInitOccludedArguments(&arguments);
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

// A query that reports every crossing: the filter notes the triangle and rejects the hit, so that traversal goes on.
struct CrossingQuery
{
  QueryArguments arguments;
#if KALOS_EMBREE_VERSION >= 4
  RTCRayQueryContext context;
#endif
  const std::function<void(std::uint32_t)>* visit;
  std::uint32_t last;  // a triangle in two leaves of the hierarchy is reported twice in a row at most
};

void noteCrossing(const RTCFilterFunctionNArguments* filter)
{
#if KALOS_EMBREE_VERSION >= 4
  auto* query =
      reinterpret_cast<CrossingQuery*>(reinterpret_cast<char*>(filter->context) - offsetof(CrossingQuery, context));
#else
  auto* query = reinterpret_cast<CrossingQuery*>(filter->context);  // the first member
#endif
  const auto triangle = RTCHitN_primID(filter->hit, filter->N, 0);
  if (triangle != query->last)
    (*query->visit)(triangle);
  query->last = triangle;
  filter->valid[0] = 0;
}
}  // namespace

struct RayScene::Embree
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Embree()
  {
    if (this->scene)
      rtcReleaseScene(this->scene);
    if (this->device)
      rtcReleaseDevice(this->device);
  }
};

RayScene::RayScene(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, Queries queries)
    : Impl(std::make_unique<Embree>())
{
  Embree& e = *this->Impl;
  e.device = rtcNewDevice(nullptr);
  if (!e.device)
    throw std::runtime_error("Embree can not be started on this processor");
  e.scene = rtcNewScene(e.device);
  // Robust: no leaks through shared edges.
  rtcSetSceneFlags(e.scene,
                   queries == Queries::AllCrossings ? RTC_SCENE_FLAG_ROBUST | filterFlag : RTC_SCENE_FLAG_ROBUST);

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
    throw std::runtime_error("Embree can not build the ray scene of " + std::to_string(triangles.size()) +
                             " triangles");
}

RayScene::~RayScene() = default;

Hit RayScene::intersect(const Vec3& origin, const Vec3& direction) const
{
  countRays(1);
  RTCRayHit query{};
  query.ray = makeRay(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  QueryArguments arguments;
  initialise(arguments);
#if KALOS_EMBREE_VERSION >= 4
  rtcIntersect1(this->Impl->scene, &query, &arguments);
#else
  rtcIntersect1(this->Impl->scene, &arguments, &query);
#endif
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return {};
  return {true, query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar};
}

bool RayScene::occluded(const Vec3& a, const Vec3& b) const
{
  countRays(1);
  RTCRay ray = makeRay(a, b - a, 1);
  OcclusionArguments arguments;
  initialise(arguments);
#if KALOS_EMBREE_VERSION >= 4
  rtcOccluded1(this->Impl->scene, &ray, &arguments);
#else
  rtcOccluded1(this->Impl->scene, &arguments, &ray);
#endif
  return ray.tfar < 0;
}

std::uint32_t RayScene::occluded(const SegmentPacket& segments, int count) const
{
  countRays(count);
  alignas(64) int valid[SegmentPacket::width];
  alignas(64) RTCRay16 rays;
  std::memcpy(rays.org_x, segments.ox, sizeof segments.ox);
  std::memcpy(rays.org_y, segments.oy, sizeof segments.oy);
  std::memcpy(rays.org_z, segments.oz, sizeof segments.oz);
  std::memcpy(rays.dir_x, segments.dx, sizeof segments.dx);
  std::memcpy(rays.dir_y, segments.dy, sizeof segments.dy);
  std::memcpy(rays.dir_z, segments.dz, sizeof segments.dz);
  for (int i = 0; i < SegmentPacket::width; ++i)
  {
    valid[i] = i < count ? -1 : 0;
    rays.tnear[i] = 0;
    rays.tfar[i] = 1;
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.id[i] = 0;
    rays.flags[i] = 0;
  }
  OcclusionArguments arguments;
  initialise(arguments);
#if KALOS_EMBREE_VERSION >= 4
  rtcOccluded16(valid, this->Impl->scene, &rays, &arguments);
#else
  rtcOccluded16(valid, this->Impl->scene, &arguments, &rays);
#endif
  std::uint32_t mask = 0;
  for (int i = 0; i < count; ++i)
    mask |= (rays.tfar[i] < 0 ? 1u : 0u) << i;
  return mask;
}

void RayScene::crossings(const Vec3& a, const Vec3& b, const std::function<void(std::uint32_t)>& visit) const
{
  countRays(1);
  RTCRayHit query{};
  query.ray = makeRay(a, b - a, 1);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  CrossingQuery crossing;
  initialise(crossing.arguments);
  crossing.visit = &visit;
  crossing.last = RTC_INVALID_GEOMETRY_ID;
#if KALOS_EMBREE_VERSION >= 4
  rtcInitRayQueryContext(&crossing.context);
  crossing.arguments.context = &crossing.context;
  crossing.arguments.filter = noteCrossing;
  crossing.arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  rtcIntersect1(this->Impl->scene, &query, &crossing.arguments);
#else
  crossing.arguments.filter = noteCrossing;
  rtcIntersect1(this->Impl->scene, &crossing.arguments, &query);
#endif
}
void RayScene::nearby(const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit) const
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
  rtcPointQuery(this->Impl->scene, &query, &context, note,
                const_cast<void*>(static_cast<const void*>(&visit)));  // Embree's user pointer is not const
}
}  // namespace kalos
