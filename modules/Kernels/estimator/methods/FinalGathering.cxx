// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/FinalGathering.h"

#include <iomanip>
#include <limits>
#include <sstream>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "estimator/methods/StrategyTrial.h"

namespace kalos
{
namespace
{
constexpr int trajectoriesPerSample = 32;  // of a replicate, per sample of direct light
constexpr std::size_t chunk = 256;         // cells that one task estimates
constexpr double largestHits = 1 << 22;    // kept at a time: 130 MB
constexpr int smallestRound = 512;         // trajectories that always fit: their vertices light the cells
constexpr int phases = 4;                  // of a round

// Width of cells over the distance that they are seen from, before it is rounded down to a power of two, for so many
// rays of each receiver in a round of one replicate. Where few rays share a cell, sharing costs more time than the
// noise it saves: cells twice as wide took 1.6 times longer to 0.5 % on a plane of 64 x 64 points, cells half as wide a
// tenth longer to 2 % on walls. With cells wider than a quarter, dark places behind a box came out 6 to 10 % too
// bright.
float cellShare(int rays, std::size_t receivers)
{
  constexpr float finest = 0.0625f, widest = 0.25f, enoughRays = 4, enoughHits = 64;
  const float hits = static_cast<float>(rays) * static_cast<float>(receivers);
  return std::clamp(std::min(enoughRays / static_cast<float>(rays), enoughHits / std::sqrt(hits)), finest, widest);
}

// A diffuse surface has the same luminance from everywhere, so that its estimate can be shared.
bool isMostlyDiffuse(const Scene& scene)
{
  double diffuse = 0;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    diffuse += scene.brdf(t).isLambertian() ? scene.area(t) : 0;
  return diffuse > 0.5 * scene.surfaceArea();
}
}  // namespace

FinalGathering::FinalGathering(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, trajectoriesPerSample),
      Rays(scene, this->Source, settings, this->Direct.shadows()),
      Spots(scene, receivers.points.size()),
      Faces(facesOf(scene)),
      Order(orderOf(this->Direct.sensors())),
      MostlyDiffuse(isMostlyDiffuse(scene))
{
}

bool FinalGathering::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  this->Checks.assign(tileCount(tally.receivers()) * tally.replicates(), {});
  if (!this->Direct.prepare(workers, tally))
    return false;
  if (this->Direct.complete() || !pathsAreBetter(this->Scene_, this->Source, this->Settings_, this->Direct))
    return true;
  this->Rays.usePathsOnly();
  this->Direct.leaveMeshesToRays();
  return this->Direct.prepare(workers, tally);
}

bool FinalGathering::trusts(std::size_t receiver, long long trajectories) const
{
  const double rays = static_cast<double>(trajectories) / this->trajectoriesPerRay() * this->groupSize();
  return this->Direct.hasAllImages() &&
         (this->Direct.complete() ||
          this->Spots.areSeen(this->Direct.sensors()[receiver], rays, this->Direct.illuminance(receiver)));
}

bool FinalGathering::sharesRays() const
{
  return !this->Rays.pathsOnly() && !this->Settings_.ownRays && this->MostlyDiffuse;
}

int FinalGathering::groupSize() const
{
  return this->sharesRays() ? ReceiverGroup::capacity : 1;
}

int FinalGathering::trajectoriesPerRay() const
{
  constexpr int unshared = 32, least = 16, most = 256;
  if (!this->sharesRays())
    return unshared;
  int each = least;
  while (each < most && static_cast<double>(each) * each < 8 * static_cast<double>(this->Order.size()))
    each *= 2;
  return each;
}

Pace FinalGathering::pace() const
{
  const double scores = this->sharesRays() ? 48 : 16;  // in the time of a gather ray with its whole path
  const int each = this->trajectoriesPerRay();
  return {each, smallestRound, scores / each};
}

bool FinalGathering::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const std::vector<LightVertices> pools =
      this->Rays.trace(this->Source, this->Settings_.walks(), this->Replicates, first, count, workers);
  if (pools.empty())
    return false;
  tally.noteEnergy(pools);
  const int each = this->trajectoriesPerRay(), rays = (count + each - 1) / each;
  std::vector<Replicate> round(this->Replicates);
  for (int p = 0; p < this->Replicates; ++p)
  {
    round[p].pool = {&pools[p], count};
    round[p].cellShare = cellShare(rays, tally.active());
  }

  // As many replicates at a time as there is room for their hits.
  const Workers::Replicates mine = workers.mine(this->Replicates);
  const double hits = static_cast<double>(rays) * static_cast<double>(tally.receivers());
  const int together = static_cast<int>(std::clamp(largestHits / hits, 1.0, static_cast<double>(this->Replicates)));
  const int steps = phases * ((mine.last - mine.first + together - 1) / together);
  bool going = true;
  for (int p = mine.first, step = 0; going && p < mine.last; p += together, step += phases)
  {
    auto next = [&, phase = step]() mutable { workers.setStep(phase++, steps); };
    going = this->addReplicates({p, std::min(mine.last, p + together)}, round, first, rays, next, workers, tally);
  }
  this->RaysDone += rays;
  return going;
}

bool FinalGathering::addReplicates(Workers::Replicates some, std::vector<Replicate>& round, long long first, int rays,
                                   const std::function<void()>& nextPhase, Workers& workers, Tally& tally)
{
  const int bands = this->Scene_.bands();
  const std::size_t tiles = tileCount(tally.receivers());
  std::vector<GatherHits> gathered(tiles * static_cast<std::size_t>(some.last - some.first));
  auto hitsOf = [&](std::size_t tile, int p) -> GatherHits& {
    return gathered[static_cast<std::size_t>(p - some.first) * tiles + tile];
  };

  // Trace the gather rays.
  nextPhase();
  bool going = workers.forEachReplicate(some, tiles, [&](int p, std::size_t tile) {
    this->traceGatherRays(tile, p, round[p], rays, hitsOf(tile, p), tally);
  });

  // Sort the hits into cells, in the receivers' order, and estimate each cell at its representative.
  nextPhase();
  going = going && workers.forEachReplicate(some, 1, [&](int p, std::size_t) {
    const std::uint64_t seed = this->seedOfCells(p);
    for (std::size_t tile = 0; tile < tiles; ++tile)
      for (SurfaceHit& hit : hitsOf(tile, p).hits)
        round[p].grid.add(hit, seed);
    round[p].indirect.resize(round[p].grid.cells().size() * bands);
    this->Checks[p].cells += static_cast<double>(round[p].grid.cells().size());
  });
  std::size_t chunks = 0;
  for (int p = some.first; p < some.last; ++p)
    chunks = std::max(chunks, (round[p].grid.cells().size() + chunk - 1) / chunk);
  nextPhase();
  going = going && workers.forEachReplicate(some, chunks, [&](int p, std::size_t part) {
    const auto& cells = round[p].grid.cells();
    WavefrontGather wave(this->Rays, round[p].pool);
    const std::size_t begin = std::min(cells.size(), part * chunk), end = std::min(cells.size(), begin + chunk);
    for (std::size_t c = begin; c < end; ++c)
      this->estimate(cells[c].representative, p, wave);
    wave.run();
    for (std::size_t c = begin; c < end; ++c)
      std::copy_n(wave.light(c - begin), bands, &round[p].indirect[c * bands]);
  });

  // Light the receivers by the hits.
  nextPhase();
  going = going && workers.forEachReplicate(some, tiles, [&](int p, std::size_t tile) {
    this->collect(tile, p, round[p], rays, hitsOf(tile, p), tally, this->Checks[tile * this->Replicates + p]);
    const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
      this->Direct.score(r, p, first, round[p].pool.trajectories, tally);
  });
  for (int p = some.first; p < some.last; ++p)
  {
    round[p].grid = {};
    round[p].indirect = {};
  }
  return going;
}

void FinalGathering::exchange(const Ranks& ranks)
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

void FinalGathering::persist(Archive& archive)
{
  archive.value(this->RaysDone);
  archive.array(this->Checks);
}

AuditLine FinalGathering::auditNeighbours() const
{
  if (this->sharesRays())
    return {"neighbours", "groups of " + std::to_string(ReceiverGroup::capacity),
            "a hit of one receiver's gather ray also lights the others, with one shadow ray each"};
  return {"neighbours", "each by itself",
          this->Settings_.ownRays  ? "as requested"
          : this->Rays.pathsOnly() ? "luminous surfaces are all around: unshared rays take less time"
                                   : "most surfaces are glossy: their luminance depends on the viewer"};
}

std::vector<AuditLine> FinalGathering::audit() const
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
  if (this->Rays.pathsOnly())
    lines.push_back(auditPaths());
  lines.push_back(this->auditNeighbours());
  lines.push_back({"cells", cells.str(), share.str()});
  lines.push_back({"bias", amount.str(), "of the gathered light, measured by rays that share no estimate"});
  return lines;
}
}  // namespace kalos
