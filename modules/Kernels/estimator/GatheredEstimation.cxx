// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/GatheredEstimation.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "estimator/GatherPattern.h"
#include "estimator/PathTrial.h"

namespace kalos
{
namespace
{
constexpr int trajectoriesPerRay = 16;  // of a replicate, for each gather ray of a receiver in that replicate
constexpr int fewReplicates = 8;        // fewer are better stratified; their standard error is good to a quarter
constexpr float cellShare = 0.25f;      // width over distance, rounded down to a power of two
constexpr double checkEvery = 64;       // shared hits, for each that is estimated at its own place too
constexpr std::size_t chunk = 64;       // cells that one task estimates

// Random numbers of the cells: others than those of the receivers.
std::uint64_t seedOfCells(std::uint64_t seed, int replicate, long long first)
{
  return mixBits(mixBits(seed + 0x5eed) + static_cast<std::uint64_t>(replicate)) +
         mixBits(static_cast<std::uint64_t>(first));
}

constexpr Gathering::Start whole(bool seesEmission)
{
  return {std::numeric_limits<double>::infinity(), seesEmission};
}
}  // namespace

GatheredEstimation::GatheredEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Lit(scene),
      Wanted(settings),
      Source(scene),
      Direct(scene, receivers, settings),
      Rays(scene, this->Source, settings, this->Direct.shadows()),
      Faces(facesOf(scene))
{
}

bool GatheredEstimation::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  this->Checks.assign(tileCount(tally.receivers()) * tally.replicates(), {});
  if (!this->Direct.prepare(workers, tally))
    return false;
  if (this->Direct.complete() || !pathsAreBetter(this->Lit, this->Source, this->Wanted, this->Direct))
    return true;
  this->Rays.goAlone();
  this->Direct.leaveMeshesToRays();
  return this->Direct.prepare(workers, tally);
}

int GatheredEstimation::replicates(long long trajectories) const
{
  return std::min(fewReplicates, replicateCount(trajectories));
}

bool GatheredEstimation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const std::vector<VertexPool> pools =
      this->Rays.trace(this->Source, this->Wanted.walks(), this->Replicates, first, count, workers);
  if (pools.empty())
    return false;
  tally.noteEnergy(pools);
  std::vector<Replicate> round(this->Replicates);
  for (int p = 0; p < this->Replicates; ++p)
    round[p].pool = {&pools[p], count};

  // See where the rays end.
  const int rays = (count + trajectoriesPerRay - 1) / trajectoriesPerRay, bands = this->Lit.bands();
  const std::size_t tiles = tileCount(tally.receivers());
  std::vector<Looks> looks(tiles * this->Replicates);
  auto at = [&](std::size_t tile, int replicate) { return tile * this->Replicates + replicate; };
  bool going = workers.forEachReplicate(this->Replicates, tiles, [&](int p, std::size_t tile) {
    this->look(tile, p, round[p], rays, looks[at(tile, p)], tally);
  });

  // Sort the hits into cells, in the receivers' order, and estimate each cell at its representative.
  going = going && workers.forEachReplicate(this->Replicates, 1, [&](int p, std::size_t) {
    const std::uint64_t seed = seedOfCells(this->Wanted.seed, p, this->RaysDone);
    for (std::size_t tile = 0; tile < tiles; ++tile)
      for (SurfaceHit& hit : looks[at(tile, p)].hits)
        round[p].cache.add(hit, seed);
    round[p].indirect.resize(round[p].cache.cells().size() * bands);
    this->Checks[p].cells += static_cast<double>(round[p].cache.cells().size());
  });
  std::size_t chunks = 0;
  for (const Replicate& one : round)
    chunks = std::max(chunks, (one.cache.cells().size() + chunk - 1) / chunk);
  going = going && workers.forEachReplicate(this->Replicates, chunks, [&](int p, std::size_t part) {
    const auto& cells = round[p].cache.cells();
    for (std::size_t c = part * chunk; c < std::min(cells.size(), (part + 1) * chunk); ++c)
    {
      const Bands e = this->indirectLight(cells[c].representative, c, p, round[p].pool);
      std::copy_n(e.begin(), bands, &round[p].indirect[c * bands]);
    }
  });

  // Light the receivers by what was found.
  going = going && workers.forEachReplicate(this->Replicates, tiles, [&](int p, std::size_t tile) {
    this->collect(tile, p, round[p], rays, looks[at(tile, p)], tally, this->Checks[at(tile, p)]);
    const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
      this->Direct.score(r, p, first, count, tally);
  });
  this->RaysDone += rays;
  return going;
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
        hit.cell = cellKey(face, hit, t, cellShare);
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
  SampleStream random(Sampling::Independent, seedOfCells(this->Wanted.seed, replicate, this->RaysDone),
                      static_cast<std::uint64_t>(replicate), Purpose::Gather, cell);
  return this->Rays.indirectLight(this->at(hit), pool, random);
}

void GatheredEstimation::collect(std::size_t tile, int replicate, const Replicate& round, int rays, const Looks& looks,
                                 Tally& tally, Check& check) const
{
  const int bands = tally.bands();
  const double weight = static_cast<double>(round.pool.trajectories) / rays;
  // Each hit draws a luminaire of its own.
  const std::uint64_t seed = mixBits(seedOfCells(this->Wanted.seed, replicate, this->RaysDone) + tile + 1);
  std::size_t i = 0, r = tile * tileSize;
  for (const std::size_t end : looks.ends)
  {
    const bool exactMeshes = this->Direct.exactMeshes(r);
    Bands sum{}, emission{};
    double largest = 0;
    for (; i < end; ++i)
    {
      const SurfaceHit& hit = looks.hits[i];
      const Material& material = this->Lit.material(hit.side / 2);
      const double* e = &round.indirect[hit.cell * bands];
      SampleStream random(Sampling::Independent, seed, static_cast<std::uint64_t>(replicate), Purpose::Gather, i);
      const Bands direct = this->Rays.luminaireLight(this->at(hit), random);
      Bands value;
      for (int b = 0; b < bands; ++b)
      {
        const double m = (hit.side & 1) && !exactMeshes ? material.exitance[b] : 0;
        value[b] = m + material.reflectance[b] * (direct[b] + e[b]);
        emission[b] += m;
        sum[b] += value[b];
      }
      const double luminous = photometric(value, bands);
      largest = luminous >= 0 ? std::max(largest, luminous) : std::numeric_limits<double>::quiet_NaN();  // to stay
      check.sum += luminous;
      if (round.cache.cells()[hit.cell].hits < 2)
        continue;
      check.shared += 1;
      if (std::fmod(check.shared, checkEvery) == checkEvery / 2)
      {
        const Bands own = this->indirectLight(hit, hit.cell, replicate, round.pool);
        Bands difference;
        for (int b = 0; b < bands; ++b)
          difference[b] = material.reflectance[b] * (e[b] - own[b]);
        check.excess += checkEvery * photometric(difference, bands);
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

void GatheredEstimation::exchange(const Ranks& ranks)
{
  ranks.exchange(this->Replicates, [this](int first, int last, const auto& visit) {
    for (std::size_t tile = 0; tile * this->Replicates < this->Checks.size(); ++tile)
      for (int replicate = first; replicate < last; ++replicate)
      {
        Check& check = this->Checks[tile * this->Replicates + replicate];
        for (double* value : {&check.excess, &check.sum, &check.rays, &check.shared, &check.cells})
          visit(*value);
      }
  });
}

void GatheredEstimation::persist(Archive& archive)
{
  archive.value(this->RaysDone);
  archive.array(this->Checks);
}

std::vector<AuditLine> GatheredEstimation::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  if (this->Direct.complete() || this->Checks.empty())
    return lines;
  std::vector<double> excess(this->Replicates);
  double rays = 0, shared = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < this->Checks.size(); ++i)
  {
    rays += this->Checks[i].rays;
    shared += this->Checks[i].shared;
    sum += this->Checks[i].sum;
    count += this->Checks[i].cells;
    excess[i % this->Replicates] += this->Checks[i].excess;
  }
  const MeanAndError bias = summarise(excess.data(), excess.size());
  const double scale = sum > 0 ? 100 * this->Replicates / sum : 0;
  std::ostringstream cells, share, amount;
  cells << std::setprecision(3) << rays / std::max(1.0, count) << " gather rays per cell";
  share << std::setprecision(3) << 100 * shared / std::max(1.0, rays)
        << " % of the rays share an estimate with others; cells are as wide as a share of the viewing distance";
  amount << std::showpos << std::setprecision(2) << scale * bias.mean << " +- " << std::noshowpos
         << scale * bias.standardError << " %";
  lines.push_back({"kernel", "gathered", "fast, with a bias that falls with the width of its cells"});
  if (this->Rays.alone())
    lines.push_back(auditPaths());
  lines.push_back({"cells", cells.str(), share.str()});
  lines.push_back({"bias", amount.str(), "of the gathered light, measured by rays that share no estimate"});
  return lines;
}
}  // namespace kalos
