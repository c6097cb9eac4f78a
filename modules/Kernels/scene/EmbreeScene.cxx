// SPDX-License-Identifier: BSD-3-Clause
#include "scene/EmbreeScene.h"

#include <cstring>
#include <limits>
#include <stdexcept>

#include "scene/RayCount.h"

namespace kalos
{
namespace
{
void addTriangles(RTCDevice device, RTCScene scene, const std::vector<Vec3>& points,
                  const std::vector<Triangle>& triangles)
{
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
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
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}
}  // namespace

void EmbreeScene::build(const std::vector<Vec3>& meshPoints, const std::vector<Triangle>& meshTriangles)
{
  this->device = rtcNewDevice(nullptr);
  if (!this->device)
    throw std::runtime_error("Embree cannot start on this processor");
  this->scene = rtcNewScene(this->device);
  // Robust mode: no leaks through shared edges.
  rtcSetSceneFlags(this->scene, RTC_SCENE_FLAG_ROBUST | embree::filterFlag);
  this->points = meshPoints;
  this->triangles = meshTriangles;
  for (const Vec3& p : this->points)
    this->extent = std::max(this->extent, maxAbs(p));
  if (!this->triangles.empty())
    addTriangles(this->device, this->scene, this->points, this->triangles);
  rtcCommitScene(this->scene);
  if (rtcGetDeviceError(this->device) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the ray scene of " + std::to_string(this->triangles.size()) +
                             " triangles");
}

EmbreeScene::~EmbreeScene()
{
  if (this->scene)
    rtcReleaseScene(this->scene);
  if (this->device)
    rtcReleaseDevice(this->device);
}

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

EmbreeScene::Query EmbreeScene::ask(const RayAnchor& start, const Vec3& direction, const RayAnchor* end,
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

void EmbreeScene::addNear(const RayAnchor& anchor, std::vector<std::uint32_t>& near) const
{
  if (!anchor.crowded)
    return;
  search(this->scene, anchor.point, RayScene::crowd * anchor.lift(), [&](std::uint32_t t) {
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
bool EmbreeScene::isBetween(const Query& query, std::uint32_t triangle) const
{
  const Triangle& t = this->triangles[triangle];
  const Vec3 a = this->points[t[0]], n = cross(this->points[t[1]] - a, this->points[t[2]] - a);
  const double side = dot(n, endFor(query.start, n) - a);
  const double towards = dot(n, query.end ? endFor(*query.end, n) - a : query.direction);
  return side * towards < 0;
}

// Along the ray to the plane of a triangle, in lengths of its direction.
double EmbreeScene::distanceTo(const Query& query, std::uint32_t triangle) const
{
  const Triangle& t = this->triangles[triangle];
  const Vec3 a = this->points[t[0]], n = cross(this->points[t[1]] - a, this->points[t[2]] - a);
  return -dot(n, query.start.point - a) / dot(n, query.direction);
}

Hit EmbreeScene::meet(const Query& query, std::uint32_t triangle, double& distance) const
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

Hit EmbreeScene::firstNear(const Query& query, double& distance) const
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

void EmbreeScene::keepAhead(const RTCFilterFunctionNArguments* filter)
{
  const auto& query = *reinterpret_cast<const Query*>(filter->context);
  const std::uint32_t t = RTCHitN_primID(filter->hit, filter->N, 0);
  if (std::find(query.near.begin(), query.near.end(), t) != query.near.end() || !query.scene->isBetween(query, t))
    filter->valid[0] = 0;
}

Hit EmbreeScene::first(const RayAnchor& start, const Vec3& direction) const
{
  countRays(1);
  RTCRayHit hit{};
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query = this->ask(start, direction, nullptr, hit.ray);
  double distance;
  const Hit near = this->firstNear(query, distance);
  embree::traceFirst(this->scene, query.context, keepAhead, hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID || (near.valid && distance < this->distanceTo(query, hit.hit.primID)))
    return near;
  return {true, hit.hit.primID, hit.hit.u, hit.hit.v};
}

void EmbreeScene::search(RTCScene scene, const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit)
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
