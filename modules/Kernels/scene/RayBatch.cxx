// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RayBatch.h"

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;
constexpr double far = 250;  // times the lift of the start

// The rays of a packet and their indices.
struct Packet
{
  SegmentPacket segments;
  std::size_t ray[width];
  int count = 0;
};

// Stores the hits of a packet; retraces in double precision where single precision is not accurate enough.
void trace(const Scene& scene, Packet& packet, std::vector<PathRay>& rays)
{
  HitPacket hits;
  scene.rays().intersect(packet.segments, packet.count, hits);
  for (int i = 0; i < packet.count; ++i)
  {
    PathRay& ray = rays[packet.ray[i]];
    const auto distance = static_cast<double>(hits.distance[i]);
    // A miss may have slipped between two triangles.
    if (hits.triangle[i] == HitPacket::noTriangle || !isFarFrom(ray.start, distance * distance))
      ray.end = scene.trace(ray.start, ray.direction);
    else
      ray.end = scene.point({true, hits.triangle[i], hits.u[i], hits.v[i]}, ray.direction);
  }
  packet.count = 0;
}

void shadow(const RayScene& scene, Packet& packet, std::vector<ShadowRay>& rays)
{
  const std::uint32_t hidden = scene.occluded(packet.segments, packet.count);
  for (int i = 0; i < packet.count; ++i)
    rays[packet.ray[i]].hidden = hidden >> i & 1;
  packet.count = 0;
}
}  // namespace

double squaredNearness(const RayAnchor& start)
{
  const double nearness = far * start.lift();
  return nearness * nearness;
}

bool isFarFrom(const RayAnchor& start, double squaredDistance)
{
  return squaredDistance > squaredNearness(start);
}

bool crowds(const RayAnchor& start, double squaredDistance)
{
  const double reach = RayScene::crowd * start.lift();
  return squaredDistance < reach * reach;
}

bool isInGap(const Scene& scene, const RayAnchor& anchor)
{
  if (anchor.crowded)
    return true;
  const SurfacePoint y = scene.trace(anchor, anchor.normal);
  const Vec3 d = y.position - anchor.point;
  return y.valid && !isFarFrom(anchor, dot(d, d));
}

void traceTogether(const Scene& scene, std::vector<PathRay>& rays)
{
  Packet packet;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    if (rays[i].doublePrecision || rays[i].start.crowded)
    {
      rays[i].end = scene.trace(rays[i].start, rays[i].direction);
      continue;
    }
    packet.segments.set(packet.count, rays[i].start.lifted(), rays[i].direction);
    packet.ray[packet.count++] = i;
    if (packet.count == width)
      trace(scene, packet, rays);
  }
  if (packet.count > 0)
    trace(scene, packet, rays);
}

void shadowTogether(const RayScene& scene, std::vector<ShadowRay>& rays)
{
  Packet packet;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    ShadowRay& ray = rays[i];
    const Vec3 along = ray.to.point - ray.from.point;
    const double squared = dot(along, along);
    if (ray.doublePrecision || ray.from.crowded || ray.to.crowded || !isFarFrom(ray.from, squared) ||
        !isFarFrom(ray.to, squared))
    {
      ray.hidden = scene.occluded(ray.from, ray.to);
      continue;
    }
    packet.segments.set(packet.count, ray.from, ray.to);
    packet.ray[packet.count++] = i;
    if (packet.count == width)
      shadow(scene, packet, rays);
  }
  if (packet.count > 0)
    shadow(scene, packet, rays);
  for (std::size_t i = 0; scene.panes() && i < rays.size(); ++i)
    if (!rays[i].hidden)
      rays[i].transmittance = scene.transmittance(rays[i].from, rays[i].to);
}
}  // namespace kalos
