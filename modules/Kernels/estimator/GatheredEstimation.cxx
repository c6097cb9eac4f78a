// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/GatheredEstimation.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "sampling/Warp.h"

namespace kalos
{
namespace
{
// Least variance per second over a floor and a plane in a room, of 1 to 16 and of 8, 16 and 32: fewer replicates are
// better stratified, and their standard error is still good to a fifth.
constexpr int trajectoriesPerRay = 4;  // of a replicate, for each gather ray of a receiver in that replicate
constexpr int fewReplicates = 16;
constexpr int checkEvery = 32;            // cached rays, for each that is estimated without the cache too
constexpr double cellsAcross = 48;        // along the square root of the scene's area
constexpr int layingReplicate = 1 << 20;  // no estimate uses it

// Random numbers of the cache: others than those of the receivers.
Settings ofCache(Settings settings)
{
  settings.seed = mixBits(settings.seed + 0x5eed);
  return settings;
}

int rayCount(int trajectories)
{
  return (trajectories + trajectoriesPerRay - 1) / trajectoriesPerRay;
}
}  // namespace

GatheredEstimation::GatheredEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Lit(scene),
      Wanted(settings),
      Source(scene),
      Direct(scene, receivers, settings),
      Light(scene, this->Source, ofCache(settings), this->Direct.shadows())
{
}

bool GatheredEstimation::prepare(Workers& workers, Tally& tally)
{
  if (!this->Direct.prepare(workers, tally))
    return false;
  if (this->Direct.complete())
    return true;
  this->Replicates = tally.replicates();
  this->Checks.assign(tileCount(tally.receivers()) * tally.replicates(), {});
  if (!this->layCache(workers))
    return false;
  this->Cached = std::make_unique<Tally>(this->Lit, this->CacheSensors.size(), tally.replicates());
  return this->Light.prepare(this->CacheSensors, workers);
}

int GatheredEstimation::replicates(long long trajectories) const
{
  return std::min(fewReplicates, replicateCount(trajectories));
}

bool GatheredEstimation::layCache(Workers& workers)
{
  // Look around from the receivers: what they see is what the cache must hold. Few receivers look less often in all:
  // they would not ask for its points often enough to pay for them.
  constexpr std::size_t looks = 50000;
  const auto& sensors = this->Direct.sensors();
  const std::size_t each = std::clamp<std::size_t>(looks / std::max<std::size_t>(1, sensors.size()), 4, 32);
  const double cell = std::sqrt(this->Lit.surfaceArea()) / cellsAcross;
  std::vector<std::vector<SurfaceCache::Record>> seen(tileCount(sensors.size()));
  const bool looked = workers.forEach(seen.size(), [&](std::size_t tile) {
    for (std::size_t r = tile * tileSize; r < std::min(sensors.size(), (tile + 1) * tileSize); ++r)
    {
      const Frame frame(sensors[r].normal);
      const Walks walks = this->Wanted.walks().ofReceiver(r);
      for (std::size_t k = 0; k < each && !sensors[r].brdf; ++k)
      {
        SampleStream random = walks.stream(layingReplicate, Purpose::Gather, static_cast<long long>(k));
        const double u1 = random.next(), u2 = random.next();
        const Vec3 direction = frame.toWorld(cosineHemisphere(u1, u2));
        const SurfacePoint y = this->Lit.trace(sensors[r].position, sensors[r].normal, direction);
        if (y.valid && this->Lit.brdf(y.triangle).isLambertian() && length(y.position - sensors[r].position) > cell)
          seen[tile].push_back({y.position, y.normal});
      }
    }
  });
  std::vector<SurfaceCache::Record> all;
  for (const auto& part : seen)
    all.insert(all.end(), part.begin(), part.end());
  this->Cache = SurfaceCache(cell, all);
  for (const SurfaceCache::Record& record : this->Cache.records())
    this->CacheSensors.emplace_back(this->Lit, record.position, record.normal);
  return looked;
}

bool GatheredEstimation::fillCache(const Round& round, Workers& workers)
{
  const std::size_t tiles = tileCount(this->CacheSensors.size());
  const bool filled = workers.forEachReplicate(this->Replicates, tiles, [&](int replicate, std::size_t tile) {
    const std::size_t end = std::min(this->CacheSensors.size(), (tile + 1) * tileSize);
    for (std::size_t i = tile * tileSize; i < end; ++i)
      this->Light.score(this->CacheSensors[i], i, replicate, round, false, *this->Cached);
  });
  this->Light.finish(round);
  this->Trajectories += round.count;
  return filled;
}

bool GatheredEstimation::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const Round round = this->Light.trace(first, count, this->Replicates, workers);
  if (round.pools.empty() || !this->fillCache(round, workers))
    return false;
  tally.noteEnergy(round.pools);
  const std::size_t tiles = tileCount(tally.receivers());
  return workers.forEachReplicate(this->Replicates, tiles, [&](int replicate, std::size_t tile) {
    const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
    {
      this->gather(r, replicate, round, tally, this->Checks[tile * this->Replicates + replicate]);
      this->Direct.score(r, replicate, first, count, tally);
    }
  });
}

void GatheredEstimation::exchange(const Ranks& ranks)
{
  ranks.exchange(this->Replicates, [this](int first, int last, const auto& visit) {
    for (std::size_t tile = 0; tile * this->Replicates < this->Checks.size(); ++tile)
      for (int replicate = first; replicate < last; ++replicate)
      {
        Check& check = this->Checks[tile * this->Replicates + replicate];
        visit(check.excess);
        visit(check.sum);
        for (long long* count : {&check.rays, &check.cached})
        {
          auto value = static_cast<double>(*count);
          visit(value);
          *count = static_cast<long long>(value);
        }
      }
  });
}

void GatheredEstimation::persist(Archive& archive)
{
  if (this->Direct.complete())
    return;
  this->Light.persist(archive);
  this->Cached->persist(archive);
  archive.value(this->Trajectories);
  archive.array(this->Checks);
}

void GatheredEstimation::exchangeState(const Ranks& ranks)
{
  if (this->Cached)
    this->Cached->exchange(ranks);
}

bool GatheredEstimation::fromCache(const SurfacePoint& y, int replicate, SampleStream& random, Bands& e) const
{
  const double u = random.next(), v = random.next();
  const int record = this->Cache.find(y.position, y.normal, u, v);
  if (record < 0)
    return false;
  e = this->Light.gathering().luminaireLight(Sensor(this->Lit, y.position, y.normal), random);
  const double* held = this->Cached->total(static_cast<std::size_t>(record), replicate);
  for (int b = 0; b < this->Lit.bands(); ++b)
    e[b] += held[b] / static_cast<double>(this->Trajectories);
  return true;
}

void GatheredEstimation::gather(std::size_t r, int replicate, const Round& round, Tally& tally, Check& check) const
{
  const int bands = this->Lit.bands(), rays = rayCount(round.count);
  const Sensor& sensor = this->Direct.sensors()[r];
  const bool exactMeshes = this->Direct.exactMeshes(r);
  const Walks walks = this->Wanted.walks().ofReceiver(r);
  const GatherPool pool{&round.pools[replicate], round.count};
  const Gathering::Start whole{std::numeric_limits<double>::infinity(), !exactMeshes};
  const Frame frame(sensor.normal);
  Bands sum{}, emission{};
  for (long long k = round.first; k < round.first + rays; ++k)
  {
    SampleStream random = walks.stream(replicate, Purpose::Gather, k);
    const SampleStream again = random;
    auto unbiased = [&](Bands& emitted) {
      SampleStream stream = again;
      return this->Light.gathering().gather(sensor, pool, whole, stream, emitted);
    };
    Bands value{}, e;
    ++check.rays;
    const double u1 = random.next(), u2 = random.next();
    const Vec3 direction = frame.toWorld(cosineHemisphere(u1, u2));
    const SurfacePoint y = sensor.brdf ? SurfacePoint() : this->Lit.trace(sensor.position, sensor.normal, direction);
    if (!sensor.brdf && !y.valid)
      continue;
    if (sensor.brdf || !this->Lit.brdf(y.triangle).isLambertian() ||
        length(y.position - sensor.position) < this->Cache.cell() || !this->fromCache(y, replicate, random, e))
    {
      value = unbiased(emission);
      tally.noteScore(r, replicate,
                      photometric(value, bands) * round.count / rays);  // what the cache holds has no tail
    }
    else
    {
      const Material& material = this->Lit.material(y.triangle);
      for (int b = 0; b < bands; ++b)
      {
        const double m = y.front && !exactMeshes ? material.exitance[b] : 0;
        value[b] = m + material.reflectance[b] * e[b];
        emission[b] += m;
      }
      if (check.cached++ % checkEvery == 0)
      {
        Bands unused{};
        check.excess += checkEvery * (photometric(value, bands) - photometric(unbiased(unused), bands));
      }
    }
    check.sum += photometric(value, bands);
    for (int b = 0; b < bands; ++b)
      sum[b] += value[b];
  }
  const double weight = static_cast<double>(round.count) / rays;
  for (int b = 0; b < bands; ++b)
  {
    tally.total(r, replicate)[b] += weight * sum[b];
    tally.direct(r, replicate)[b] += weight * emission[b];
  }
}

std::vector<AuditLine> GatheredEstimation::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  if (this->Direct.complete() || this->Checks.empty())
    return lines;
  std::vector<double> excess(this->Replicates);
  double rays = 0, cached = 0, sum = 0;
  for (std::size_t i = 0; i < this->Checks.size(); ++i)
  {
    rays += static_cast<double>(this->Checks[i].rays);
    cached += static_cast<double>(this->Checks[i].cached);
    sum += this->Checks[i].sum;
    excess[i % this->Replicates] += this->Checks[i].excess;
  }
  const MeanAndError bias = summarise(excess.data(), excess.size());
  const double scale = sum > 0 ? 100 * this->Replicates / sum : 0;
  std::ostringstream cache, share, amount;
  cache << this->Cache.records().size() << " points, cells of " << std::setprecision(2) << this->Cache.cell() << " m";
  share << std::setprecision(3) << 100 * cached / std::max(1.0, rays) << " % of the gather rays use them";
  amount << std::showpos << std::setprecision(2) << scale * bias.mean << " +- " << std::noshowpos
         << scale * bias.standardError << " %";
  lines.push_back({"kernel", "gathered", "fast, with a bias that falls with the cells of its cache"});
  lines.push_back({"surface cache", cache.str(), share.str()});
  lines.push_back({"bias", amount.str(), "of the reflected light, measured by rays that do without the cache"});
  return lines;
}
}  // namespace kalos
