// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/BiasCompensation.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

#include "estimator/gathering/VertexScores.h"
#include "estimator/tracing/VertexRound.h"

namespace kalos
{
namespace
{
// At right angles, where no surface in front is nearer than this fraction of the square root of the scene's area,
// vertices without gather rays had no more variance: in a closet, an office, a hall with furniture and a dark room
// behind a door.
constexpr double clearance = 0.08;

// Gather rays per trajectory of a sensor that gathers, over the root of the vertices per trajectory. The best number is
// proportional to the root of a trajectory's cost. On the floor, a plane and a wall of a furnished room 0.007 and 0.024
// took 2 to 20 % more time to the same error; more rays where more of the hemisphere is near took 5 % more there, and
// as much at points along an edge.
constexpr double raysPerRoot = 0.016;

// Number of receivers at which scoring a trajectory takes as long as tracing it. With fewer receivers, a trajectory
// costs each of them more. Along an edge, 48 receivers, twice the rays took three quarters of the time to the same
// error.
constexpr double receiversPerTrace = 128;

// How often a gather ray counts in the balance heuristic. Vertices cover open space evenly but score in spikes nearby,
// so a ray is worth more than one vertex sample where both compete. On the floor, a plane and a wall of a furnished
// room 2 and 8 took up to 8 and 13 % more time than 4 to the same error.
constexpr double rayWorth = 4;

// Only gather rays find light from mirrors, and glossy vertices score in spikes.
bool isDiffuse(const Scene& scene)
{
  const auto& materials = scene.data().materials;
  return std::all_of(materials.begin(), materials.end(),
                     [](const Material& m) { return m.specular == 0 && m.mirror == 0; });
}
}  // namespace

BiasCompensation::BiasCompensation(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows,
                                   std::size_t receivers)
    : Scene_(scene),
      Source(emission),
      Settings_(settings),
      ReceiverCount(receivers),
      Rays(scene, emission, settings, shadows),
      Clearance(!settings.uses(Technique::Near) || !isDiffuse(scene) ? std::numeric_limits<double>::infinity()
                                                                     : clearance * std::sqrt(scene.surfaceArea()))
{
}

bool BiasCompensation::prepare(const std::vector<Sensor>& sensors, Workers& workers)
{
  this->Gathers.resize(sensors.size());
  this->RaysDone.assign(sensors.size(), 0);
  return workers.forEach(tileCount(sensors.size()), [&](std::size_t tile) {
    for (std::size_t r = tile * tileSize; r < std::min(sensors.size(), (tile + 1) * tileSize); ++r)
      this->Gathers[r] = this->needsRays(sensors[r]);
  });
}

double BiasCompensation::rayShare() const
{
  const double cost = 1 + receiversPerTrace / static_cast<double>(std::max<std::size_t>(1, this->ReceiverCount));
  return raysPerRoot * std::sqrt(cost * (this->Rays.pilot().collisions() + this->Rays.pilot().starts()));
}

bool BiasCompensation::needsRays(const Sensor& sensor) const
{
  return this->Rays.pathsOnly() || !std::isfinite(this->Clearance) ||
         !this->Scene_.clear(sensor.position, sensor.normal, this->Clearance);
}

double BiasCompensation::balance(std::size_t r, const Round& round) const
{
  return this->Rays.pathsOnly() ? std::numeric_limits<double>::infinity()
                                : rayWorth * this->rays(r, round) / round.count;
}

Round BiasCompensation::trace(long long first, int count, int replicates, Workers& workers) const
{
  // A power of two, because a Sobol' sequence is evenly stratified over that many points.
  const double rays = std::exp2(std::max(0.0, std::round(std::log2(this->rayShare() * count))));
  return {first, count, static_cast<int>(rays),
          this->Rays.trace(this->Source, this->Settings_.walks(), replicates, first, count, workers)};
}

void BiasCompensation::score(const std::vector<Sensor>& sensors, std::size_t begin, std::size_t end, int replicate,
                             const Round& round, const std::function<bool(std::size_t)>& exactMeshes,
                             Tally& tally) const
{
  const GatherPool pool{&round.pools[replicate], round.count};
  ReceiverRays gathered(this->Rays, pool, replicate, tally);
  for (std::size_t r = begin; r < end; ++r)
  {
    if (tally.converged(r))
      continue;
    if (!this->Rays.pathsOnly())
      addVertexScores(this->Rays, round.pools[replicate], sensors[r], this->balance(r, round), exactMeshes(r),
                      receiverStream(this->Settings_.seed, replicate, Purpose::Selection, r, round.first), r, replicate,
                      tally);
    this->sendRays(sensors[r], r, replicate, round, exactMeshes(r), gathered);
  }
  gathered.finish();
}

void BiasCompensation::finish(const Round& round, const Tally& tally)
{
  for (std::size_t r = 0; r < this->RaysDone.size(); ++r)
    this->RaysDone[r] += tally.converged(r) ? 0 : this->rays(r, round);
  this->TrajectoriesDone += round.count;
}

void BiasCompensation::sendRays(const Sensor& sensor, std::size_t r, int replicate, const Round& round,
                                bool exactMeshes, ReceiverRays& gathered) const
{
  const int rays = this->rays(r, round);  // none where vertices score everything
  const Walks walks = this->Settings_.walks().ofReceiver(r);
  const WavefrontGather::Start start{this->balance(r, round), !exactMeshes, sensor.doublePrecision};
  for (long long k = this->RaysDone[r]; k < this->RaysDone[r] + rays; ++k)
    gathered.gather(r, rays, sensor, start, walks.stream(replicate, Purpose::Gather, k));
}

std::vector<double> BiasCompensation::raysSent(int replicates) const
{
  std::vector<double> sent;
  for (const long long rays : this->RaysDone)
    sent.push_back(static_cast<double>(rays) * replicates);
  return sent;
}

AuditLine BiasCompensation::audit(int replicates, const std::vector<double>& edgeDistances) const
{
  std::size_t gathering = 0, atEdges = 0;
  for (std::size_t r = 0; r < this->Gathers.size(); ++r)
  {
    gathering += this->Gathers[r] != 0;
    atEdges += this->Gathers[r] && r < edgeDistances.size() && edgeDistances[r] < this->Clearance;
  }
  const std::vector<double> sent = this->raysSent(replicates);
  const double spared = this->rayShare() * static_cast<double>(this->TrajectoriesDone) * replicates *
                        static_cast<double>(this->Gathers.size() - gathering);
  std::ostringstream reason;
  reason << std::setprecision(3);
  if (this->Rays.pathsOnly())
    reason << "they find all light; ";
  else if (std::isfinite(this->Clearance))
    reason << "where surfaces in front weigh as much as a wall within " << this->Clearance << " m; ";
  else
    reason << (this->Settings_.uses(Technique::Near) ? "needed for surfaces that are not diffuse; " : "as requested; ");
  reason << std::llround(std::accumulate(sent.begin(), sent.end(), 0.0)) << " rays, " << std::llround(spared)
         << " spared elsewhere";
  if (std::isfinite(this->Clearance) && edgeDistances.size() == this->Gathers.size())
    reason << "; " << atEdges << " receivers at singular edges, " << gathering - atEdges << " in gaps";
  return {"gather rays",
          "at " + std::to_string(gathering) + " of " + std::to_string(this->Gathers.size()) + " receivers",
          reason.str()};
}
}  // namespace kalos
