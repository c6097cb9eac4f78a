// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/FinalGathering.h"

#include "estimator/gathering/VertexScores.h"
#include "estimator/methods/StrategyTrial.h"
#include "estimator/tracing/VertexRound.h"

namespace kalos
{
namespace
{
constexpr int trajectoriesPerSample = 32;  // of a replicate, per sample of direct light
constexpr double largestHits = 1 << 22;    // kept at a time: 130 MB
constexpr int smallestRound = 512;         // trajectories that always fit: their vertices light the cells
constexpr int phases = 4;                  // of a round
}  // namespace

FinalGathering::FinalGathering(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, trajectoriesPerSample),
      Rays(scene, this->Source, settings, this->Direct.shadows()),
      Plan(scene, this->Direct.sensors(), settings),
      Tracer(this->Rays, this->Direct, this->Plan, settings),
      Spots(this->Rays),
      Accumulation(this->Rays, this->Direct, this->Plan, this->Spots)
{
}

bool FinalGathering::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  this->Check.reset(tileCount(tally.receivers()), tally.replicates());
  if (!this->Direct.prepare(workers, tally))
    return false;
  if (this->Direct.complete())
    return true;
  if (!pathsAreBetter(this->Scene_, this->Source, this->Settings_, this->Direct))
  {
    this->Spots.prepare(this->Direct.sensors());
    return true;
  }
  this->Rays.usePathsOnly();
  this->Plan.leaveToPaths();
  this->Direct.leaveMeshesToRays();
  return this->Direct.prepare(workers, tally);
}

Pace FinalGathering::pace() const
{
  const double scores = this->Plan.sharesRays() ? 48 : 16;  // in the time of a gather ray with its whole path
  const int each = this->Plan.trajectoriesPerRay();
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
  std::vector<CellShading> round;
  round.reserve(this->Replicates);
  for (int p = 0; p < this->Replicates; ++p)
    round.emplace_back(this->Rays, this->Plan.round({&pools[p], count}, p, this->RaysDone, tally.active()));

  // As many replicates at a time as there is room for their hits.
  const Workers::Replicates mine = workers.mine(this->Replicates);
  const int rays = round.front().round().rays;
  const double hits = static_cast<double>(rays) * static_cast<double>(tally.receivers());
  const int together = static_cast<int>(std::clamp(largestHits / hits, 1.0, static_cast<double>(this->Replicates)));
  const int steps = phases * ((mine.last - mine.first + together - 1) / together);
  bool going = true;
  for (int p = mine.first, step = 0; going && p < mine.last; p += together, step += phases)
  {
    auto next = [&, phase = step]() mutable { workers.setStep(phase++, steps); };
    going = this->addReplicates({p, std::min(mine.last, p + together)}, round, first, next, workers, tally);
  }
  this->RaysDone += rays;
  return going;
}

bool FinalGathering::addReplicates(Workers::Replicates some, std::vector<CellShading>& round, long long first,
                                   const std::function<void()>& nextPhase, Workers& workers, Tally& tally)
{
  const std::size_t tiles = tileCount(tally.receivers());
  std::vector<GatherHits> gathered(tiles * static_cast<std::size_t>(some.last - some.first));
  auto hitsOf = [&](std::size_t tile, int p) -> GatherHits& {
    return gathered[static_cast<std::size_t>(p - some.first) * tiles + tile];
  };

  // Trace the gather rays.
  nextPhase();
  bool going = workers.forEachReplicate(some, tiles, [&](int p, std::size_t tile) {
    this->Tracer.trace(tile, round[p].round(), hitsOf(tile, p), tally);
  });

  // Sort the hits into cells, in the receivers' order, and estimate each cell at its representative.
  nextPhase();
  going = going && workers.forEachReplicate(some, 1, [&](int p, std::size_t) {
    for (std::size_t tile = 0; tile < tiles; ++tile)
      round[p].add(hitsOf(tile, p).hits);
    round[p].reserve();
    this->Check.of(0, p).cells += static_cast<double>(round[p].cells());
  });
  std::size_t parts = 0;
  for (int p = some.first; p < some.last; ++p)
    parts = std::max(parts, round[p].parts());
  nextPhase();
  going = going && workers.forEachReplicate(some, parts, [&](int p, std::size_t part) { round[p].shade(part); });

  // Light the receivers by the hits, and by the vertices of bright spots.
  nextPhase();
  std::vector<LightVertices> spots(static_cast<std::size_t>(some.last - some.first));
  going = going && workers.forEachReplicate(some, 1, [&](int p, std::size_t) {
    spots[static_cast<std::size_t>(p - some.first)] = this->Spots.select(
        *round[p].round().pool.vertices, 0x1.0p-53 * static_cast<double>(mixBits(round[p].round().seed) >> 11));
  });
  going = going && workers.forEachReplicate(some, tiles, [&](int p, std::size_t tile) {
    this->Accumulation.add(tile, hitsOf(tile, p), round[p], tally, this->Check.of(tile, p));
    this->scoreSpots(tile, spots[static_cast<std::size_t>(p - some.first)], first, round[p].round(), tally);
    const std::size_t end = std::min(tally.receivers(), (tile + 1) * tileSize);
    for (std::size_t r = tile * tileSize; r < end; ++r)
      this->Direct.score(r, p, first, round[p].round().pool.trajectories, tally);
  });
  for (int p = some.first; p < some.last; ++p)
    round[p].clear();
  return going;
}

void FinalGathering::scoreSpots(std::size_t tile, const LightVertices& spots, long long first, const GatherRound& round,
                                Tally& tally) const
{
  if (spots.reflected.size() + spots.emitted.size() == 0)
    return;
  for (const ReceiverGroup& group : this->Plan.groups(tile, tally))
  {
    const double rays = this->Plan.raysPerTrajectory(group, round);
    for (int k = 0; k < group.size(); ++k)
    {
      const std::size_t r = group.receiver(k);
      addVertexScores(this->Rays, spots, this->Direct.sensors()[r], rays, this->Direct.exactMeshes(r),
                      receiverStream(this->Settings_.seed, round.replicate, Purpose::Selection, r, first), r,
                      round.replicate, tally);
    }
  }
}

void FinalGathering::persist(Archive& archive)
{
  archive.value(this->RaysDone);
  this->Check.persist(archive);
}

std::vector<AuditLine> FinalGathering::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  if (this->Direct.complete() || this->Check.empty())
    return lines;
  lines.push_back({"kernel", "gathered", "fast, with a bias that falls with the width of its cells"});
  if (this->Rays.pathsOnly())
    lines.push_back(auditPaths());
  lines.push_back(this->Plan.audit());
  for (AuditLine& line : this->Check.audit())
    lines.push_back(std::move(line));
  return lines;
}
}  // namespace kalos
