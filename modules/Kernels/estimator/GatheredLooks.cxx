// SPDX-License-Identifier: BSD-3-Clause
// What one tile of receivers sees in a round of estimator/GatheredEstimation.h, and how that lights it.
#include "estimator/GatheredEstimation.h"

#include <limits>

#include "estimator/GatherPattern.h"

namespace kalos
{
namespace
{
constexpr int checkEvery = 64;  // shared hits, for each that is estimated at its own place too

constexpr Gathering::Start whole(bool seesEmission)
{
  return {std::numeric_limits<double>::infinity(), seesEmission};
}
}  // namespace

// Random numbers of the cells: others than those of the receivers.
std::uint64_t GatheredEstimation::seedOfCells(int replicate) const
{
  return mixBits(mixBits(this->Wanted.seed + 0x5eed) + static_cast<std::uint64_t>(replicate)) +
         mixBits(static_cast<std::uint64_t>(this->RaysDone));
}

void GatheredEstimation::look(std::size_t tile, int replicate, const Replicate& round, int rays, Looks& looks,
                              Tally& tally) const
{
  const auto& sensors = this->Direct.sensors();
  const std::uint64_t key =
      mixBits(mixBits(this->Wanted.seed + tile) + static_cast<std::uint64_t>(replicate)) + 0x67617468;
  const GatherPattern pattern(this->Wanted.sampling, key, this->RaysDone, rays);
  for (std::size_t r = tile * tileSize; r < std::min(sensors.size(), (tile + 1) * tileSize); ++r)
  {
    if (tally.rests(r))
    {
      looks.ends.push_back(looks.hits.size());
      continue;
    }
    if (!sensors[r].brdf)
      this->lookAt(r, replicate, round, pattern, looks, tally);
    else
    {
      const Walks walks = this->Wanted.walks().ofReceiver(r);
      Bands sum{}, emission{};
      const double weight = static_cast<double>(round.pool.trajectories) / rays;
      for (long long k = this->RaysDone; k < this->RaysDone + rays; ++k)
      {
        SampleStream random = walks.stream(replicate, Purpose::Gather, k);
        const Bands found =
            this->Rays.gather(sensors[r], round.pool, whole(!this->Direct.exactMeshes(r)), random, emission);
        tally.noteScore(r, replicate, weight * photometric(found, tally.bands()));
        for (int b = 0; b < tally.bands(); ++b)
          sum[b] += found[b];
      }
      for (int b = 0; b < tally.bands(); ++b)
      {
        tally.total(r, replicate)[b] += weight * sum[b];
        tally.direct(r, replicate)[b] += weight * emission[b];
      }
    }
    looks.ends.push_back(looks.hits.size());
  }
}

void GatheredEstimation::lookAt(std::size_t r, int replicate, const Replicate& round, const GatherPattern& pattern,
                                Looks& looks, Tally& tally) const
{
  constexpr int width = SegmentPacket::width;
  const Sensor& sensor = this->Direct.sensors()[r];
  const std::uint64_t key = mixBits(this->Wanted.seed + r) + static_cast<std::uint64_t>(replicate);
  SegmentPacket packet;
  HitPacket found;
  for (int begin = 0; begin < pattern.size(); begin += width)
  {
    const int count = std::min(width, pattern.size() - begin);
    pattern.rays(sensor.anchor.lifted, sensor.normal, key, begin, packet);
    this->Lit.rays().intersect(packet, count, found);
    for (int i = 0; i < count; ++i)
    {
      const std::uint32_t triangle = found.triangle[i];
      if (triangle == HitPacket::noTriangle)
        continue;
      const Face& face = this->Faces[triangle];
      const float d[3] = {packet.dx[i], packet.dy[i], packet.dz[i]}, t = found.distance[i];
      const bool front = face.normal[0] * d[0] + face.normal[1] * d[1] + face.normal[2] * d[2] < 0;
      SurfaceHit hit{{packet.ox[i] + t * d[0], packet.oy[i] + t * d[1], packet.oz[i] + t * d[2]},
                     2 * triangle + (front ? 1 : 0),
                     0};
      if (this->Lit.brdf(triangle).isLambertian())
      {
        hit.cell = cellKey(face, hit, t, round.cellShare);
        looks.hits.push_back(hit);
        continue;
      }
      const long long k = this->RaysDone + begin + i;
      SampleStream random =
          Walks{this->Wanted.seed, Sampling::Independent}.ofReceiver(r).stream(replicate, Purpose::Gather, k);
      const SurfacePoint y = this->Lit.trace(sensor.position, sensor.normal, {d[0], d[1], d[2]});
      Bands emission{};
      const Bands value = this->Rays.follow(sensor, {d[0], d[1], d[2]}, y, round.pool,
                                            whole(!this->Direct.exactMeshes(r)), random, emission);
      const double weight = static_cast<double>(round.pool.trajectories) / pattern.size();
      tally.noteScore(r, replicate, weight * photometric(value, tally.bands()));
      for (int b = 0; b < tally.bands(); ++b)
      {
        tally.total(r, replicate)[b] += weight * value[b];
        tally.direct(r, replicate)[b] += weight * emission[b];
      }
    }
  }
}

Sensor GatheredEstimation::at(const SurfaceHit& hit) const
{
  const std::uint32_t triangle = hit.side / 2;
  const Vec3 n = hit.side & 1 ? this->Lit.normal(triangle) : -this->Lit.normal(triangle);
  Vec3 p{hit.position[0], hit.position[1], hit.position[2]};
  p += dot(this->Lit.corner(triangle, 0) - p, n) * n;  // into the plane, to double precision
  return Sensor(this->Lit, p, n);
}

Bands GatheredEstimation::indirectLight(const SurfaceHit& hit, std::size_t cell, int replicate,
                                        const GatherPool& pool) const
{
  SampleStream random(Sampling::Independent, this->seedOfCells(replicate), static_cast<std::uint64_t>(replicate),
                      Purpose::Gather, cell);
  return this->Rays.indirectLight(this->at(hit), pool, random);
}

void GatheredEstimation::lightByLamps(std::size_t receiver, const SurfaceHit* hits, int count, SampleStream& random,
                                      Bands* light) const
{
  // A packet's rays start an offset above the surface: where hits are so near that this is too much, each has a ray.
  constexpr double far = 1000;  // offsets
  const Sensor& from = this->Direct.sensors()[receiver];
  const double least = far * length(from.anchor.lifted - from.position);
  Sensor sensors[SegmentPacket::width];
  bool afar = true;
  for (int i = 0; i < count; ++i)
  {
    sensors[i] = this->at(hits[i]);
    const Vec3 d = sensors[i].position - from.position;
    afar = afar && dot(d, d) > least * least;
  }
  if (afar)
    this->Rays.luminaireLight(sensors, count, random, light);
  else
    for (int i = 0; i < count; ++i)
      light[i] = this->Rays.luminaireLight(sensors[i], random);
}

void GatheredEstimation::collect(std::size_t tile, int replicate, const Replicate& round, int rays, const Looks& looks,
                                 Tally& tally, Check& check) const
{
  const int bands = tally.bands();
  const double weight = static_cast<double>(round.pool.trajectories) / rays;
  const std::uint64_t seed = mixBits(this->seedOfCells(replicate) + tile + 1);
  std::size_t begin = 0, r = tile * tileSize;
  for (const std::size_t end : looks.ends)
  {
    if (tally.rests(r))
    {
      ++r;
      continue;
    }
    const bool exactMeshes = this->Direct.exactMeshes(r);
    Bands sum{}, emission{}, lamps[SegmentPacket::width];
    double largest = 0;
    for (; begin < end; begin = std::min(end, begin + SegmentPacket::width))
    {
      // Each hit draws a luminaire of its own; a packet of them shares a stream of random numbers.
      const SurfaceHit* hits = &looks.hits[begin];
      const int count = static_cast<int>(std::min<std::size_t>(SegmentPacket::width, end - begin));
      SampleStream random(Sampling::Independent, seed, static_cast<std::uint64_t>(replicate), Purpose::Gather, begin);
      this->lightByLamps(r, hits, count, random, lamps);
      for (int i = 0; i < count; ++i)
      {
        const Material& material = this->Lit.material(hits[i].side / 2);
        const double* e = &round.indirect[hits[i].cell * bands];
        Bands value;
        for (int b = 0; b < bands; ++b)
        {
          const double m = (hits[i].side & 1) && !exactMeshes ? material.exitance[b] : 0;
          value[b] = m + material.reflectance[b] * (lamps[i][b] + e[b]);
          emission[b] += m;
          sum[b] += value[b];
        }
        const double luminous = photometric(value, bands);
        largest = luminous >= 0 ? std::max(largest, luminous) : std::numeric_limits<double>::quiet_NaN();  // to stay
        check.sum += luminous;
        this->checkShared(hits[i], replicate, round, check);
      }
    }
    check.rays += rays;
    tally.noteScore(r, replicate, weight * largest);
    for (int b = 0; b < bands; ++b)
    {
      tally.total(r, replicate)[b] += weight * sum[b];
      tally.direct(r, replicate)[b] += weight * emission[b];
    }
    ++r;
  }
}

void GatheredEstimation::checkShared(const SurfaceHit& hit, int replicate, const Replicate& round, Check& check) const
{
  if (round.cache.cells()[hit.cell].hits < 2)
    return;
  check.shared += 1;
  if (static_cast<long long>(check.shared) % checkEvery != checkEvery / 2)
    return;
  const int bands = this->Lit.bands();
  const Material& material = this->Lit.material(hit.side / 2);
  const Bands own = this->indirectLight(hit, hit.cell, replicate, round.pool);
  Bands difference;
  for (int b = 0; b < bands; ++b)
    difference[b] = material.reflectance[b] * (round.indirect[hit.cell * bands + b] - own[b]);
  check.excess += checkEvery * photometric(difference, bands);
}
}  // namespace kalos
