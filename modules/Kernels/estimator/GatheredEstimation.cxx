// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/GatheredEstimation.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "estimator/PathTrial.h"

namespace kalos
{
namespace
{
constexpr int trajectoriesPerRay = 32;  // of a replicate, for each gather ray of a receiver in that replicate
constexpr int fewReplicates = 8;        // fewer are better stratified; their standard error is good to a quarter
constexpr std::size_t chunk = 64;       // cells that one task estimates

}  // namespace

GatheredEstimation::GatheredEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Lit(scene),
      Wanted(settings),
      Source(scene),
      Direct(scene, receivers, settings, trajectoriesPerRay),
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

Pace GatheredEstimation::pace() const
{
  constexpr double scores = 16;  // as long as a gather ray takes, with its share of a cell
  return {trajectoriesPerRay, scores / trajectoriesPerRay};
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
    const std::uint64_t seed = this->seedOfCells(p);
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
