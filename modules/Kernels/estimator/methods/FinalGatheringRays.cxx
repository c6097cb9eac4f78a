// SPDX-License-Identifier: BSD-3-Clause
// Traces the gather rays of one tile of receivers; see estimator/methods/FinalGathering.h.
#include "estimator/methods/FinalGathering.h"

#include <limits>

#include "estimator/gathering/GatherPattern.h"

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;

constexpr WavefrontGather::Start wholeLight(bool seesEmission, bool doublePrecision)
{
  return {std::numeric_limits<double>::infinity(), seesEmission, doublePrecision};
}

// Whether a receiver cannot use the hits of its neighbours' rays.
bool sharesNoHits(const Sensor& sensor)
{
  return sensor.brdf || sensor.anchor.crowded;
}
}  // namespace

// The seed of the cells' random numbers, separate from those of the receivers.
std::uint64_t FinalGathering::seedOfCells(int replicate) const
{
  return mixBits(mixBits(this->Settings_.seed + 0x5eed) + static_cast<std::uint64_t>(replicate)) +
         mixBits(static_cast<std::uint64_t>(this->RaysDone));
}

std::vector<ReceiverGroup> FinalGathering::groups(std::size_t tile, const Tally& tally) const
{
  const auto& sensors = this->Direct.sensors();
  std::vector<ReceiverGroup> found;
  for (std::size_t i = tile * tileSize; i < std::min(sensors.size(), (tile + 1) * tileSize); ++i)
  {
    const std::size_t r = this->Order[i];
    if (tally.converged(r) || sharesNoHits(sensors[r]))
      continue;
    if (found.empty() || found.back().size() == this->groupSize())
      found.emplace_back();
    found.back().add(r, sensors[r]);
  }
  return found;
}

int FinalGathering::raysOfEach(const ReceiverGroup& group, int rays) const
{
  int size = 1;
  while (size < group.size())
    size *= 2;
  return rays * this->groupSize() / size;
}

void FinalGathering::traceGatherRays(std::size_t tile, int replicate, const Replicate& round, int rays,
                                     GatherHits& gathered, Tally& tally) const
{
  const auto& sensors = this->Direct.sensors();
  const std::uint64_t key =
      mixBits(mixBits(this->Settings_.seed + tile) + static_cast<std::uint64_t>(replicate)) + 0x67617468;
  const long long first = this->RaysDone * this->groupSize();
  const int count = rays * this->groupSize();  // of a group, and of a receiver that shares no hits
  const GatherPattern pattern(this->Settings_.sampling, key, first, count);
  ReceiverRays unshared(this->Rays, round.pool, replicate, tally);
  SegmentPacket drawn;
  RayPacketBuffer buffer;
  for (std::size_t i = tile * tileSize; i < std::min(sensors.size(), (tile + 1) * tileSize); ++i)
  {
    const std::size_t r = this->Order[i];
    if (tally.converged(r) || !sharesNoHits(sensors[r]))
      continue;
    const Walks walks = this->Settings_.walks().ofReceiver(r);
    for (long long k = first; k < first + count; ++k)
      unshared.gather(r, count, sensors[r], wholeLight(!this->Direct.exactMeshes(r), sensors[r].anchor.crowded),
                      walks.stream(replicate, Purpose::Gather, k));
  }
  for (const ReceiverGroup& group : this->groups(tile, tally))
  {
    const std::uint64_t own = mixBits(this->Settings_.seed + group.receiver(0)) + static_cast<std::uint64_t>(replicate);
    std::vector<GatherStart> starts;
    for (int k = 0; k < group.size(); ++k)
    {
      const Sensor& sensor = sensors[group.receiver(k)];
      starts.emplace_back(sensor.anchor.lifted(), sensor.normal, own);
    }
    const int each = this->raysOfEach(group, rays);
    for (int begin = 0; begin < pattern.size(); begin += width)
    {
      pattern.rays(starts, each, own, begin, drawn);
      for (int i = begin; i < std::min(begin + width, pattern.size()); ++i)
      {
        const int finder = pattern.place(i) / each;
        if (finder >= group.size())
          continue;
        buffer.add(drawn, i - begin, finder, pattern.place(i) % each);
        if (buffer.count == width)
          this->tracePacket(buffer, group, replicate, each, round, gathered, unshared);
      }
    }
    this->tracePacket(buffer, group, replicate, each, round, gathered, unshared);
    gathered.ends.push_back(gathered.hits.size());
  }
  unshared.finish();
}

bool FinalGathering::locateHit(const Sensor& sensor, const SegmentPacket& packet, const HitPacket& found, int i,
                               SurfaceHit& hit, float& distance) const
{
  const float d[3] = {packet.dx[i], packet.dy[i], packet.dz[i]};
  distance = found.distance[i];
  hit.near = false;
  if (found.triangle[i] == HitPacket::noTriangle || !isFarFrom(sensor.anchor, static_cast<double>(distance * distance)))
  {
    // A miss in single precision may have slipped between two triangles.
    const SurfacePoint y = this->Scene_.trace(sensor.anchor, {d[0], d[1], d[2]});
    if (!y.valid)
      return false;
    const Vec3 along = y.position - sensor.position;
    distance = static_cast<float>(length(along));
    hit.near = !isFarFrom(sensor.anchor, dot(along, along));
    hit.side = 2 * y.triangle + (y.front ? 1 : 0);
    const Vec3& p = y.position;
    for (const auto& [k, x] : {std::pair{0, p.x}, {1, p.y}, {2, p.z}})
      hit.position[k] = static_cast<float>(x);
    return true;
  }
  const Face& face = this->Faces[found.triangle[i]];
  const bool front = face.normal[0] * d[0] + face.normal[1] * d[1] + face.normal[2] * d[2] < 0;
  hit.side = 2 * found.triangle[i] + (front ? 1 : 0);
  hit.position[0] = packet.ox[i] + distance * d[0];
  hit.position[1] = packet.oy[i] + distance * d[1];
  hit.position[2] = packet.oz[i] + distance * d[2];
  return true;
}

void FinalGathering::tracePacket(RayPacketBuffer& buffer, const ReceiverGroup& group, int replicate, int each,
                                 const Replicate& round, GatherHits& gathered, ReceiverRays& unshared) const
{
  if (buffer.count == 0)
    return;
  const SegmentPacket& packet = buffer.packet;
  HitPacket found;
  this->Scene_.rays().intersect(packet, buffer.count, found);
  for (int i = 0; i < buffer.count; ++i)
  {
    const std::size_t r = group.receiver(buffer.finder[i]);
    const Sensor& sensor = this->Direct.sensors()[r];
    const Vec3 direction{packet.dx[i], packet.dy[i], packet.dz[i]};
    SurfaceHit hit;
    float distance;
    if (!this->locateHit(sensor, packet, found, i, hit, distance))
      continue;
    hit.finder = static_cast<std::uint8_t>(buffer.finder[i]);
    const std::uint32_t triangle = hit.side / 2;
    if (this->Scene_.brdf(triangle).isLambertian())
    {
      hit.cell = cellKey(this->Faces[triangle], hit, distance, round.cellShare);
      gathered.hits.push_back(hit);
      continue;
    }
    const Walks walks{this->Settings_.seed, Sampling::Independent};
    unshared.follow(
        r, each, sensor, direction, this->Scene_.trace(sensor.anchor, direction),
        wholeLight(!this->Direct.exactMeshes(r), false),
        walks.ofReceiver(r).stream(replicate, Purpose::Gather, this->RaysDone * this->groupSize() + buffer.ray[i]));
  }
  buffer.count = 0;
}

Sensor FinalGathering::at(const SurfaceHit& hit) const
{
  const std::uint32_t triangle = hit.side / 2;
  const Vec3 n = hit.side & 1 ? this->Scene_.normal(triangle) : -this->Scene_.normal(triangle);
  Vec3 p{hit.position[0], hit.position[1], hit.position[2]};
  p += dot(this->Scene_.corner(triangle, 0) - p, n) * n;  // onto the plane, in double precision
  return Sensor(this->Scene_.anchor(triangle, p, n));
}

void FinalGathering::estimate(const SurfaceHit& hit, int replicate, WavefrontGather& wave) const
{
  wave.indirectLight(this->at(hit), hit.near,
                     SampleStream(Sampling::Independent, this->seedOfCells(replicate),
                                  static_cast<std::uint64_t>(replicate), Purpose::Gather, hit.cell));
}
}  // namespace kalos
