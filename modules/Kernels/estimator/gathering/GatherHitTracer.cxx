// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/GatherHitTracer.h"

#include <limits>

#include "estimator/gathering/GatherPattern.h"

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;

// Rays drawn from a lobe over its albedo, of one gather ray that has met it: at most one. Against single unbiased rays
// for all that glossy surfaces reflect, the time to 1 % fell to a third over a polished floor, to a quarter at the foot
// of a polished block, and to a tenth around a lamp above a polished plate.
constexpr double lobeRays = 5;

constexpr WavefrontGather::Start wholeLight(bool seesEmission, bool doublePrecision)
{
  return {std::numeric_limits<double>::infinity(), seesEmission, doublePrecision};
}

constexpr WavefrontGather::Start lobeAlone(double factor)
{
  return {std::numeric_limits<double>::infinity(), false, false, true, factor};
}

bool hasLuminousMeshes(const Scene& scene)
{
  const auto& all = scene.data().materials;
  return std::any_of(all.begin(), all.end(),
                     [&](const Material& m) { return photometric(m.exitance, scene.bands()) > 0; });
}
}  // namespace

void GatherHitTracer::RayPacketBuffer::add(const SegmentPacket& from, int i, int receiver, int index)
{
  this->packet.set(this->count, {from.ox[i], from.oy[i], from.oz[i]}, {from.dx[i], from.dy[i], from.dz[i]});
  this->finder[this->count] = receiver;
  this->ray[this->count++] = index;
}

GatherHitTracer::GatherHitTracer(const GatherContext& gathering, const ReceiverDirectLight& direct,
                                 const GatherPlan& plan, const Settings& settings)
    : Rays(gathering),
      Direct(direct),
      Plan(plan),
      Settings_(settings),
      Faces(facesOf(gathering.scene())),
      HasLuminousMeshes(hasLuminousMeshes(gathering.scene()))
{
}

void GatherHitTracer::trace(std::size_t tile, const GatherRound& round, GatherHits& gathered, Tally& tally) const
{
  const auto& sensors = this->Direct.sensors();
  const auto replicate = static_cast<std::uint64_t>(round.replicate);
  const std::uint64_t key = mixBits(mixBits(this->Settings_.seed + tile) + replicate) + 0x67617468;
  const int count = round.rays * this->Plan.groupSize();  // of a group, and of a receiver that shares no hits
  const GatherPattern pattern(this->Settings_.walks().sampling, key, round.first * this->Plan.groupSize(), count);
  ReceiverRays unshared(this->Rays, round.pool, round.replicate, tally);
  SegmentPacket drawn;
  RayPacketBuffer buffer;
  this->traceLoners(tile, round, count, unshared, tally);
  for (const ReceiverGroup& group : this->Plan.groups(tile, tally))
  {
    const std::uint64_t own = mixBits(this->Settings_.seed + group.receiver(0)) + replicate;
    std::vector<GatherStart> starts;
    for (int k = 0; k < group.size(); ++k)
    {
      const Sensor& sensor = sensors[group.receiver(k)];
      starts.emplace_back(sensor.anchor.lifted(), sensor.normal, own);
    }
    const int each = this->Plan.raysOfEach(group, round.rays);
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
          this->tracePacket(buffer, group, each, round, gathered, unshared);
      }
    }
    this->tracePacket(buffer, group, each, round, gathered, unshared);
    gathered.ends.push_back(gathered.hits.size());
  }
  unshared.finish();
}

void GatherHitTracer::traceLoners(std::size_t tile, const GatherRound& round, int count, ReceiverRays& unshared,
                                  const Tally& tally) const
{
  const long long first = round.first * this->Plan.groupSize();
  for (const std::size_t r : this->Plan.loners(tile, tally))
  {
    const Sensor& sensor = this->Direct.sensors()[r];
    const Walks walks = this->Settings_.walks().ofReceiver(r);
    for (long long k = first; k < first + count; ++k)
      unshared.gather(r, count, sensor, wholeLight(!this->Direct.exactMeshes(r), sensor.anchor.crowded),
                      walks.stream(round.replicate, Purpose::Gather, k));
  }
}

bool GatherHitTracer::locateHit(const Sensor& sensor, const SegmentPacket& packet, const HitPacket& found, int i,
                                SurfaceHit& hit, float& distance) const
{
  const float d[3] = {packet.dx[i], packet.dy[i], packet.dz[i]};
  distance = found.distance[i];
  hit.near = false;
  if (found.triangle[i] == HitPacket::noTriangle || this->Rays.scene().isOverlapped(found.triangle[i]) ||
      !isFarFrom(sensor.anchor, static_cast<double>(distance * distance)))
  {
    // A miss in single precision may have slipped between two triangles.
    const SurfacePoint y = this->Rays.scene().trace(sensor.anchor, {d[0], d[1], d[2]});
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

void GatherHitTracer::tracePacket(RayPacketBuffer& buffer, const ReceiverGroup& group, int each,
                                  const GatherRound& round, GatherHits& gathered, ReceiverRays& unshared) const
{
  if (buffer.count == 0)
    return;
  const Scene& scene = this->Rays.scene();
  const SegmentPacket& packet = buffer.packet;
  HitPacket found;
  scene.rays().intersect(packet, buffer.count, found);
  for (int i = 0; i < buffer.count; ++i)
  {
    const std::size_t r = group.receiver(buffer.finder[i]);
    const Sensor& sensor = this->Direct.sensors()[r];
    SurfaceHit hit;
    float distance;
    if (!this->locateHit(sensor, packet, found, i, hit, distance))
      continue;
    hit.finder = static_cast<std::uint8_t>(buffer.finder[i]);
    const std::uint32_t triangle = hit.side / 2;
    if (scene.brdf(triangle).isLambertian())
    {
      hit.cell = cellKey(this->Faces[triangle], hit, distance, round.cellShare);
      gathered.hits.push_back(hit);
      continue;
    }
    const Walks walks{this->Settings_.seed, Sampling::Independent};
    GlossyEnd end{r, each, {packet.dx[i], packet.dy[i], packet.dz[i]}, hit, distance};
    this->addGlossy(end, round,
                    walks.ofReceiver(r).stream(round.replicate, Purpose::Gather,
                                               round.first * this->Plan.groupSize() + buffer.ray[i]),
                    gathered, unshared);
  }
  buffer.count = 0;
}

bool GatherHitTracer::isShared(const Material& material) const
{
  const int bands = this->Rays.scene().bands();
  return photometric(material.reflectance, bands) > 0 || photometric(material.exitance, bands) > 0;
}

void GatherHitTracer::addGlossy(GlossyEnd& end, const GatherRound& round, SampleStream random, GatherHits& gathered,
                                ReceiverRays& unshared) const
{
  const Scene& scene = this->Rays.scene();
  const Sensor& sensor = this->Direct.sensors()[end.receiver];
  const std::uint32_t triangle = end.hit.side / 2;
  if (this->isShared(scene.material(triangle)))
  {
    end.hit.cell = cellKey(this->Faces[triangle], end.hit, end.distance, round.cellShare);
    gathered.hits.push_back(end.hit);
  }
  const SurfacePoint y = scene.trace(sensor.anchor, end.direction);
  const bool lampsApart = sensor.highlightsApart && scene.glossyPlanes().of(triangle) != GlossyPlanes::none;
  if (y.valid && lampsApart && !this->HasLuminousMeshes && scene.material(triangle).mirror == 0)
    this->followLobe(end, y, round, random, gathered, unshared);
  else
    unshared.follow(end.receiver, end.each, sensor, end.direction, y, lobeAlone(1), random);
}

void GatherHitTracer::followLobe(const GlossyEnd& end, const SurfacePoint& y, const GatherRound& round,
                                 SampleStream random, GatherHits& gathered, ReceiverRays& unshared) const
{
  const Scene& scene = this->Rays.scene();
  Sensor from(scene.anchor(y));
  from.brdf = &scene.lobe(y.triangle);
  from.outgoing = -end.direction;
  from.highlightsApart = true;
  const Bands white = uniformBands(1);
  const double albedo = from.brdf->albedo(dot(from.normal, from.outgoing), white),
               drawn = std::min(1.0, lobeRays * albedo);
  const double u0 = random.next(), u1 = random.next(), u2 = random.next();
  if (!(u0 < drawn))
    return;
  const BrdfSample ray = from.brdf->sample(from.normal, from.outgoing, white, u0 * albedo / drawn, u1, u2);
  if (!ray.alive)
    return;
  const SurfacePoint x = scene.trace(from.anchor, ray.direction);
  if (!x.valid)
    return;
  const double factor = ray.weight[0] * albedo / drawn;
  const Vec3 along = x.position - y.position;
  SurfaceHit hit = end.hit;
  hit.byLobe = true;
  hit.weight = static_cast<float>(factor);
  hit.cosine = static_cast<float>(-dot(ray.direction, x.normal));
  hit.near = !isFarFrom(from.anchor, dot(along, along));
  hit.side = 2 * x.triangle + (x.front ? 1 : 0);
  for (const auto& [k, p] : {std::pair{0, x.position.x}, {1, x.position.y}, {2, x.position.z}})
    hit.position[k] = static_cast<float>(p);
  if (this->isShared(scene.material(x.triangle)))
  {
    const float distance = end.distance + static_cast<float>(length(along));
    hit.cell = cellKey(this->Faces[x.triangle], hit, distance, round.cellShare);
    gathered.hits.push_back(hit);
  }
  if (!scene.brdf(x.triangle).isLambertian())
    unshared.follow(end.receiver, end.each, from, ray.direction, x, lobeAlone(factor), random);
}
}  // namespace kalos
