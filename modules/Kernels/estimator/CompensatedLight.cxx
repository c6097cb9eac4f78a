// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/CompensatedLight.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

#include "estimator/ProbeRays.h"
#include "estimator/VertexRound.h"

namespace kalos
{
namespace
{
// Scoring a pair costs next to nothing, a shadow ray about as much as forty pairs: of 8, 16, 24, 32 and 64 this gave
// the least variance per second on a plane and on the floor of a furnished room.
constexpr int verticesPerPick = 16;

// At right angles, and where no surface in front is nearer than this share of the square root of the scene's area,
// vertices alone had no more variance than with gather rays: in a closet, an office and a hall with furniture, and a
// dark room behind a door.
constexpr double clearance = 0.08;

// Gather rays per trajectory where a sensor gathers, over the root of the vertices that a trajectory leaves: the best
// share goes with the root of what a trajectory costs. One share for all was too small by three to four times beside
// the edges of a white furnace of 20 vertices per trajectory when it was right in a furnished room of 1.5.
constexpr double raysPerRoot = 0.012;

// How often a gather ray counts in the balance heuristic. Vertices fill the open evenly and score in spikes nearby, so
// that rays are worth more than their number where both compete: 2 took 6 to 7 % less time than 1 to the same error on
// the floor, a plane and a wall of the furnished room; 0.3 took twice the time of 1 near corners of a white furnace.
constexpr double rayWorth = 2;

// Light of a mirror reaches a receiver by gather rays only, and vertices on gloss score in spikes.
bool isDiffuse(const Scene& scene)
{
  const auto& materials = scene.data().materials;
  return std::all_of(materials.begin(), materials.end(),
                     [](const Material& m) { return m.specular == 0 && m.mirror == 0; });
}
}  // namespace

CompensatedLight::CompensatedLight(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows)
    : Lit(scene),
      Source(emission),
      Wanted(settings),
      Shadows(shadows),
      Rays(scene, emission, settings, shadows),
      Clearance(settings.gatherEverywhere || !isDiffuse(scene) ? std::numeric_limits<double>::infinity()
                                                               : clearance * std::sqrt(scene.surfaceArea()))
{
}

bool CompensatedLight::prepare(const std::vector<Sensor>& sensors, Workers& workers)
{
  this->RayShare.resize(sensors.size());
  this->RaysDone.assign(sensors.size(), 0);
  return workers.forEach(tileCount(sensors.size()), [&](std::size_t tile) {
    for (std::size_t r = tile * tileSize; r < std::min(sensors.size(), (tile + 1) * tileSize); ++r)
      this->RayShare[r] = this->chooseRayShare(sensors[r]);
  });
}

double CompensatedLight::leastShare() const
{
  return raysPerRoot * std::sqrt(this->Rays.pilot().collisions() + this->Rays.pilot().starts());
}

double CompensatedLight::chooseRayShare(const Sensor& sensor) const
{
  if (this->Rays.alone())
    return this->leastShare();
  if (std::isfinite(this->Clearance) && this->Lit.clear(sensor.position, sensor.normal, this->Clearance))
    return 0;
  // The part of its hemisphere that a receiver sees so near that 100 trajectories leave no vertex in the area 1/G.
  constexpr int probes = 16;
  double near = 0;
  sendProbes(this->Lit, sensor, probes, [&](double kernel, const Vec3& y) {
    near += gatheredShare(kernel / (100 * this->Rays.pilot().density(y))) / probes;
  });
  // Measured on the floor, a plane and a wall of a furnished room and along a row of points into an edge: 6 times the
  // near part took 2 to 9 % less time to the same error than 10; 20, 36 and 100 took more.
  return this->leastShare() * (1 + 6 * near);
}

int CompensatedLight::rays(std::size_t r, const Round& round) const
{
  return static_cast<int>(std::ceil(this->RayShare[r] * round.count));
}

double CompensatedLight::balance(std::size_t r, const Round& round) const
{
  return this->Rays.alone() ? std::numeric_limits<double>::infinity() : rayWorth * this->rays(r, round) / round.count;
}

Round CompensatedLight::trace(long long first, int count, int replicates, Workers& workers) const
{
  return {first, count, this->Rays.trace(this->Source, this->Wanted.walks(), replicates, first, count, workers)};
}

void CompensatedLight::score(const Sensor& sensor, std::size_t r, int replicate, const Round& round, bool exactMeshes,
                             Tally& tally) const
{
  if (!this->Rays.alone())
    this->scoreVertices(sensor, r, replicate, round, exactMeshes, tally);
  this->scoreGathered(sensor, r, replicate, round, exactMeshes, tally);
}

void CompensatedLight::finish(const Round& round, const Tally& tally)
{
  for (std::size_t r = 0; r < this->RaysDone.size(); ++r)
    this->RaysDone[r] += tally.rests(r) ? 0 : this->rays(r, round);
  this->TrajectoriesDone += round.count;
}

void CompensatedLight::scoreVertices(const Sensor& sensor, std::size_t r, int replicate, const Round& round,
                                     bool exactMeshes, Tally& tally) const
{
  const double share = this->balance(r, round);
  RandomStream random = receiverStream(this->Wanted.seed, replicate, Purpose::Selection, r, round.first);
  const RayScene* rays = this->Shadows ? &this->Lit.rays() : nullptr;
  auto score = [&](const VertexSet& set, double* sum) {
    for (std::size_t begin = 0; begin < set.size(); begin += VertexTile::capacity)
    {
      const auto count = static_cast<int>(std::min<std::size_t>(VertexTile::capacity, set.size() - begin));
      const int picks = this->Wanted.shadowEveryPair ? 0 : (count + verticesPerPick - 1) / verticesPerPick;
      const ShadowPicks shadows{rays, picks, random.next()};
      tally.noteScore(r, replicate, addPickedScores(set, begin, count, sensor, share, shadows, sum));
    }
  };
  const VertexPool& pool = round.pools[replicate];
  double* total = tally.total(r, replicate);
  score(pool.reflected, total);
  score(pool.glossy, total);
  if (exactMeshes)
    return;
  Bands emitted{};
  score(pool.emitted, emitted.data());
  for (int b = 0; b < tally.bands(); ++b)
  {
    total[b] += emitted[b];
    tally.direct(r, replicate)[b] += emitted[b];
  }
}

void CompensatedLight::scoreGathered(const Sensor& sensor, std::size_t r, int replicate, const Round& round,
                                     bool exactMeshes, Tally& tally) const
{
  const int rays = this->rays(r, round);
  if (rays == 0)
    return;  // vertices score everything
  const Walks walks = this->Wanted.walks().ofReceiver(r);
  const GatherPool pool{&round.pools[replicate], round.count};
  const Gathering::Start start{this->balance(r, round), !exactMeshes};
  Bands sum{}, emission{};
  for (long long k = this->RaysDone[r]; k < this->RaysDone[r] + rays; ++k)
  {
    SampleStream random = walks.stream(replicate, Purpose::Gather, k);
    const Bands gathered = this->Rays.gather(sensor, pool, start, random, emission);
    for (int b = 0; b < tally.bands(); ++b)
      sum[b] += gathered[b];
    tally.noteScore(r, replicate, photometric(gathered, tally.bands()) * round.count / rays);
  }
  const double weight = static_cast<double>(round.count) / rays;
  for (int b = 0; b < tally.bands(); ++b)
  {
    tally.total(r, replicate)[b] += weight * sum[b];
    tally.direct(r, replicate)[b] += weight * emission[b];
  }
}

std::vector<double> CompensatedLight::raysSent(int replicates) const
{
  std::vector<double> sent;
  for (const long long rays : this->RaysDone)
    sent.push_back(static_cast<double>(rays) * replicates);
  return sent;
}

AuditLine CompensatedLight::audit(int replicates, const std::vector<double>& edgeDistances) const
{
  std::size_t gathering = 0, atEdges = 0;
  for (std::size_t r = 0; r < this->RayShare.size(); ++r)
  {
    gathering += this->RayShare[r] > 0;
    atEdges += this->RayShare[r] > 0 && r < edgeDistances.size() && edgeDistances[r] < this->Clearance;
  }
  const std::vector<double> sent = this->raysSent(replicates);
  const double spared = this->leastShare() * static_cast<double>(this->TrajectoriesDone) * replicates *
                        static_cast<double>(this->RayShare.size() - gathering);
  std::ostringstream reason;
  reason << std::setprecision(3);
  if (this->Rays.alone())
    reason << "they find all light; ";
  else if (std::isfinite(this->Clearance))
    reason << "where surfaces in front weigh as much as a wall within " << this->Clearance << " m; ";
  else
    reason << (this->Wanted.gatherEverywhere ? "as was asked for; "
                                             : "surfaces that are not diffuse are seen by them; ");
  reason << std::llround(std::accumulate(sent.begin(), sent.end(), 0.0)) << " rays, " << std::llround(spared)
         << " spared elsewhere";
  if (std::isfinite(this->Clearance) && edgeDistances.size() == this->RayShare.size())
    reason << "; " << atEdges << " receivers at singular edges, " << gathering - atEdges << " in gaps";
  return {"gather rays",
          "at " + std::to_string(gathering) + " of " + std::to_string(this->RayShare.size()) + " receivers",
          reason.str()};
}
}  // namespace kalos
