// SPDX-License-Identifier: BSD-3-Clause
// What one tile of receivers sees in a round of estimator/GatheredEstimation.h, and how that lights it.
#include "estimator/GatheredEstimation.h"

#include <limits>
#include <numeric>

#include "estimator/GatherPattern.h"

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;
constexpr int checkEvery = 64;  // shared hits, for each that is estimated at its own place too

constexpr GatherWave::Start wholeLight(bool seesEmission)
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
  ReceiverRays unshared(this->Rays, round.pool, replicate, tally);
  SegmentPacket drawn;
  Sight sight;
  const std::size_t first = tile * tileSize, last = std::min(sensors.size(), first + tileSize);
  looks.ends.assign(last - first, 0);  // how many, until they are summed up
  for (std::size_t r = first; r < last; ++r)
  {
    if (tally.rests(r))
      continue;
    if (sensors[r].brdf)
    {
      const Walks walks = this->Wanted.walks().ofReceiver(r);
      for (long long k = this->RaysDone; k < this->RaysDone + rays; ++k)
        unshared.gather(r, rays, sensors[r], wholeLight(!this->Direct.exactMeshes(r)),
                        walks.stream(replicate, Purpose::Gather, k));
      continue;
    }
    // Few rays of a receiver share a packet with its neighbours'.
    const std::uint64_t own = mixBits(this->Wanted.seed + r) + static_cast<std::uint64_t>(replicate);
    for (int begin = 0; begin < rays; begin += width)
    {
      const int count = std::min(width, rays - begin);
      pattern.rays(sensors[r].anchor.lifted, sensors[r].normal, own, begin, drawn);
      for (int i = 0; i < count; ++i)
      {
        sight.add(drawn, i, r, this->RaysDone + begin + i);
        if (sight.count == width)
          this->see(sight, replicate, rays, round, looks, unshared);
      }
    }
  }
  this->see(sight, replicate, rays, round, looks, unshared);
  std::partial_sum(looks.ends.begin(), looks.ends.end(), looks.ends.begin());
  unshared.finish();
}

void GatheredEstimation::see(Sight& sight, int replicate, int rays, const Replicate& round, Looks& looks,
                             ReceiverRays& unshared) const
{
  if (sight.count == 0)
    return;
  const SegmentPacket& packet = sight.packet;
  HitPacket found;
  this->Lit.rays().intersect(packet, sight.count, found);
  for (int i = 0; i < sight.count; ++i)
  {
    const std::uint32_t triangle = found.triangle[i];
    if (triangle == HitPacket::noTriangle)
      continue;
    const std::size_t r = sight.receiver[i];
    const Sensor& sensor = this->Direct.sensors()[r];
    const Face& face = this->Faces[triangle];
    const float d[3] = {packet.dx[i], packet.dy[i], packet.dz[i]}, t = found.distance[i];
    const bool front = face.normal[0] * d[0] + face.normal[1] * d[1] + face.normal[2] * d[2] < 0;
    SurfaceHit hit{{packet.ox[i] + t * d[0], packet.oy[i] + t * d[1], packet.oz[i] + t * d[2]},
                   2 * triangle + (front ? 1 : 0),
                   0,
                   !isFarFrom(sensor.anchor, static_cast<double>(t * t))};
    if (this->Lit.brdf(triangle).isLambertian())
    {
      hit.cell = cellKey(face, hit, t, round.cellShare);
      looks.hits.push_back(hit);
      ++looks.ends[r % tileSize];
      continue;
    }
    const Vec3 direction{d[0], d[1], d[2]};
    const Walks walks{this->Wanted.seed, Sampling::Independent};
    unshared.follow(r, rays, sensor, direction, this->Lit.trace(sensor.anchor, direction),
                    wholeLight(!this->Direct.exactMeshes(r)),
                    walks.ofReceiver(r).stream(replicate, Purpose::Gather, sight.ray[i]));
  }
  sight.count = 0;
}

Sensor GatheredEstimation::at(const SurfaceHit& hit) const
{
  const std::uint32_t triangle = hit.side / 2;
  const Vec3 n = hit.side & 1 ? this->Lit.normal(triangle) : -this->Lit.normal(triangle);
  Vec3 p{hit.position[0], hit.position[1], hit.position[2]};
  p += dot(this->Lit.corner(triangle, 0) - p, n) * n;  // into the plane, to double precision
  return Sensor(this->Lit, p, n);
}

void GatheredEstimation::estimate(const SurfaceHit& hit, int replicate, GatherWave& wave) const
{
  wave.indirectLight(this->at(hit), hit.near,
                     SampleStream(Sampling::Independent, this->seedOfCells(replicate),
                                  static_cast<std::uint64_t>(replicate), Purpose::Gather, hit.cell));
}

void GatheredEstimation::lightByLamps(const SurfaceHit* hits, int count, SampleStream& random, Bands* light) const
{
  // A packet's rays start an offset above the surface: where hits are so near that this is too much, each has a ray.
  Sensor sensors[width];
  bool afar = true;
  for (int i = 0; i < count; ++i)
  {
    sensors[i] = this->at(hits[i]);
    afar = afar && !hits[i].near;
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
  std::vector<const SurfaceHit*> checked;
  Bands lamps[width];  // of sixteen hits, whosever they are
  std::size_t i = 0, r = tile * tileSize;
  for (const std::size_t end : looks.ends)
  {
    if (tally.rests(r))
    {
      ++r;
      continue;
    }
    const bool exactMeshes = this->Direct.exactMeshes(r);
    Bands sum{}, emission{};
    double largest = 0;
    for (; i < end; ++i)
    {
      const SurfaceHit& hit = looks.hits[i];
      if (i % width == 0)
      {
        // Each hit draws a luminaire of its own; a packet of them shares a stream of random numbers.
        SampleStream random(Sampling::Independent, seed, static_cast<std::uint64_t>(replicate), Purpose::Gather, i);
        this->lightByLamps(&hit, static_cast<int>(std::min<std::size_t>(width, looks.hits.size() - i)), random, lamps);
      }
      const Material& material = this->Lit.material(hit.side / 2);
      const double* e = &round.indirect[hit.cell * bands];
      Bands value;
      for (int b = 0; b < bands; ++b)
      {
        const double m = (hit.side & 1) && !exactMeshes ? material.exitance[b] : 0;
        value[b] = m + material.reflectance[b] * (lamps[i % width][b] + e[b]);
        emission[b] += m;
        sum[b] += value[b];
      }
      const double luminous = photometric(value, bands);
      largest = luminous >= 0 ? std::max(largest, luminous) : std::numeric_limits<double>::quiet_NaN();  // to stay
      check.sum += luminous;
      if (round.cache.cells()[hit.cell].hits < 2)
        continue;
      check.shared += 1;
      if (static_cast<long long>(check.shared) % checkEvery == checkEvery / 2)
        checked.push_back(&hit);
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
  check.excess += checkEvery * this->excess(checked, replicate, round);
}

double GatheredEstimation::excess(const std::vector<const SurfaceHit*>& hits, int replicate,
                                  const Replicate& round) const
{
  GatherWave wave(this->Rays, round.pool);
  for (const SurfaceHit* hit : hits)
    this->estimate(*hit, replicate, wave);
  wave.run();
  const int bands = this->Lit.bands();
  double excess = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const Material& material = this->Lit.material(hits[i]->side / 2);
    Bands difference;
    for (int b = 0; b < bands; ++b)
      difference[b] = material.reflectance[b] * (round.indirect[hits[i]->cell * bands + b] - wave.light(i)[b]);
    excess += photometric(difference, bands);
  }
  return excess;
}
}  // namespace kalos
