// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/PhotonMap.h"

#include <iomanip>
#include <numeric>
#include <sstream>

#include "sampling/Sobol.h"

namespace kalos
{
namespace
{
constexpr double photonsWanted = 100, ofTrajectories = 1e4;  // in a disc of the automatic radius
constexpr double shrinkage = -1.0 / 6;                       // power of the trajectories by which the radius falls
constexpr double largestRadius = 0.25;                       // of the scene's size
constexpr int coverageSamples = 64;
constexpr double trustedCoverage = 0.9;

// Whether a surface that faces the sensor's way lies within the rounding of the sensor's place, or `depth` below.
bool surfaceBelow(const Scene& scene, const Vec3& p, const Vec3& n, double depth)
{
  const SurfacePoint y = scene.trace(RayAnchor(p + depth * n), -n);
  return y.valid && dot(y.normal, n) > 0.7 && dot(p + depth * n - y.position, n) < 2 * depth;
}
}  // namespace

PhotonMap::PhotonMap(const Scene& scene, const Receivers& receivers, const Settings& settings)
    : Scene_(scene),
      Settings_(settings),
      Source(scene),
      Direct(scene, receivers, settings, false),
      Rays(scene, this->Source, settings, this->Direct.shadows()),
      FirstRadius(1)
{
  // R^2 pi n N = wanted (N / of)^(2/3) for N trajectories of all replicates, n collisions per trajectory and m2.
  const double density = std::max(this->Rays.pilot().typical(), 1 / scene.surfaceArea());
  this->FirstRadius = std::sqrt(photonsWanted / (pi * density) * std::pow(ofTrajectories, -2.0 / 3));
}

bool PhotonMap::prepare(Workers& workers, Tally& tally)
{
  this->Replicates = tally.replicates();
  const std::size_t receivers = tally.receivers();
  this->OnSurface.assign(receivers, 0);
  this->Covered.assign(receivers, 1);
  this->HalfCovered.assign(receivers, 1);
  this->Checks.assign(tileCount(receivers) * tally.replicates(), {});
  const long long planned = this->Settings_.trajectories ? this->Settings_.trajectories : defaultTrajectories;
  const double radius = this->radiusAfter((planned + tally.replicates() - 1) / tally.replicates());
  return this->Direct.prepare(workers, tally) && workers.forEach(tileCount(receivers), [&](std::size_t tile) {
    for (std::size_t r = tile * tileSize; r < std::min(receivers, (tile + 1) * tileSize); ++r)
    {
      const Sensor& sensor = this->Direct.sensors()[r];
      const double depth = 4 * this->Scene_.contact(sensor.position) + sensor.anchor.lift();
      this->OnSurface[r] = surfaceBelow(this->Scene_, sensor.position, sensor.normal, depth);
      if (!this->readsMap(r))
        continue;
      this->Covered[r] = static_cast<float>(this->coverage(sensor, radius));
      this->HalfCovered[r] = static_cast<float>(this->coverage(sensor, radius / 2));
    }
  });
}

double PhotonMap::radiusAfter(long long trajectories) const
{
  const double all = static_cast<double>(trajectories) * std::max(1, this->Replicates);
  const double automatic = this->FirstRadius * std::pow(all, shrinkage);
  return this->Settings_.epsilon > 0 ? this->Settings_.epsilon
                                     : std::min(automatic, largestRadius * this->Scene_.size());
}

bool PhotonMap::readsMap(std::size_t r) const
{
  return this->OnSurface[r] && (!this->Settings_.own.finalGather || this->Direct.sensors()[r].brdf);
}

PhotonLookup PhotonMap::lookup(double radius, bool firstOfMeshes) const
{
  const MethodOptions& own = this->Settings_.own;
  return {own.photons ? largestRadius * this->Scene_.size() : radius, own.photons, own.coneFilter, firstOfMeshes};
}

double PhotonMap::coverage(const Sensor& sensor, double radius) const
{
  const Frame frame(sensor.normal);
  const double depth = std::max(1e-3 * radius, 4 * this->Scene_.contact(sensor.position) + sensor.anchor.lift());
  int covered = 0;
  for (int i = 0; i < coverageSamples; ++i)
  {
    double u1, u2;
    sobolPoint(0, static_cast<std::uint32_t>(i), u1, u2);
    const double away = radius * std::sqrt(u1), phi = 2 * pi * u2;
    const Vec3 p = sensor.position + away * std::cos(phi) * frame.s + away * std::sin(phi) * frame.t;
    const bool seen = !this->Scene_.rays().occluded(sensor.position + depth * sensor.normal, p + depth * sensor.normal);
    covered += seen && surfaceBelow(this->Scene_, p, sensor.normal, depth);
  }
  return std::max(0.5, static_cast<double>(covered)) / coverageSamples;
}

Pace PhotonMap::pace() const
{
  Pace pace;
  pace.smallest = 64;
  pace.work = this->Settings_.own.finalGather ? 16 : 2;
  return pace;
}

PhotonMap::AirDiscs PhotonMap::airDiscs(double radius, const Tally& tally) const
{
  AirDiscs discs;
  std::vector<Vec3> corners;
  std::vector<Triangle> triangles;
  for (std::size_t r = 0; r < this->OnSurface.size(); ++r)
  {
    if (this->OnSurface[r] || this->Settings_.own.finalGather || tally.converged(r))
      continue;
    const Sensor& sensor = this->Direct.sensors()[r];
    const Frame frame(sensor.normal);
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      corners.push_back(sensor.position + s * radius * frame.s + t * radius * frame.t);
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
    discs.receivers.push_back(r);
  }
  if (!triangles.empty())
    discs.squares = std::make_unique<RayScene>(corners, triangles);
  return discs;
}

PhotonTree PhotonMap::trace(int replicate, long long first, int count, double radius, const AirDiscs& discs,
                            Tally& tally) const
{
  PhotonTree map(this->Scene_.bands());
  const EnergySums energy = walkTrajectories(
      this->Scene_, this->Source, this->Settings_.walks(), replicate, first, count, [&](const Segment& segment) {
        if ((segment.first && !segment.fromMesh) || segment.byMirrors)
          return;  // known exactly
        if (discs.squares)
          this->scoreCrossings(segment, replicate, radius, discs, tally);
        if (segment.end.valid)
          map.add(segment.end, -segment.direction, segment.weight, segment.first);
      });
  map.build();
  tally.energy(replicate).add(energy);
  return map;
}

void PhotonMap::scoreCrossings(const Segment& segment, int replicate, double radius, const AirDiscs& discs,
                               Tally& tally) const
{
  std::size_t last = discs.receivers.size();
  discs.squares->crossings(segment.from, segment.to, [&](std::uint32_t triangle) {
    const std::size_t disc = triangle / 2, r = discs.receivers[disc];
    const Sensor& sensor = this->Direct.sensors()[r];
    const double cosine = -dot(segment.direction, sensor.normal);
    if (disc == last || !(cosine > 0) || (segment.first && this->Direct.exactMeshes(r)))
      return;
    last = disc;  // a hit on the diagonal counts once
    const double along = dot(segment.from - sensor.position, sensor.normal) / cosine;
    const Vec3 away = segment.from + along * segment.direction - sensor.position;
    const double share = length(away) / radius;
    if (!(share < 1))
      return;
    const double filter = (this->Settings_.own.coneFilter ? 3 * (1 - share) : 1) / (pi * radius * radius);
    const Bands seen = response(sensor, -segment.direction, tally.bands());
    Bands light{};
    for (int b = 0; b < tally.bands(); ++b)
    {
      light[b] = filter * seen[b] * segment.weight[b];
      tally.total(r, replicate)[b] += light[b];
      if (segment.first)
        tally.direct(r, replicate)[b] += light[b];
    }
    tally.noteScore(r, replicate, photometric(light, tally.bands()));
  });
}

bool PhotonMap::addRound(long long first, int count, Workers& workers, Tally& tally)
{
  if (!(this->Source.totalFlux() > 0))
    return true;  // a dark scene
  if (this->Direct.complete())
    return this->Direct.scoreAll(first, count, workers, tally);
  const double radius = this->radiusAfter(first + count);
  const AirDiscs discs = this->airDiscs(radius, tally);
  std::vector<PhotonTree> maps;
  maps.reserve(static_cast<std::size_t>(tally.replicates()));
  for (int p = 0; p < tally.replicates(); ++p)
    maps.emplace_back(tally.bands());
  if (!workers.forEachReplicate(tally.replicates(), 1, [&](int replicate, std::size_t) {
        maps[replicate] = this->trace(replicate, first, count, radius, discs, tally);
      }))
    return false;
  // A task owns its tile and replicate, so that no sum depends on the threads.
  return workers.forEachReplicate(
      tally.replicates(), tileCount(tally.receivers()), [&](int replicate, std::size_t tile) {
        Check& check = this->Checks[tile * tally.replicates() + replicate];
        for (std::size_t r = tile * tileSize; r < std::min(tally.receivers(), (tile + 1) * tileSize); ++r)
        {
          if (tally.converged(r))
            continue;
          if (this->readsMap(r))
            this->scoreMap(r, replicate, maps[replicate], radius, check, tally);
          else if (this->Settings_.own.finalGather)
            this->gather(r, replicate, first, count, maps[replicate], radius, tally);
          this->Direct.score(r, replicate, first, count, tally);
        }
      });
}

void PhotonMap::scoreMap(std::size_t r, int replicate, const PhotonTree& map, double radius, Check& check,
                         Tally& tally) const
{
  const bool exact = this->Direct.exactMeshes(r);
  const PhotonEstimate found = map.estimate(this->Direct.sensors()[r], this->lookup(radius, !exact));
  for (int b = 0; b < tally.bands(); ++b)
  {
    tally.total(r, replicate)[b] += found.light[b];
    tally.direct(r, replicate)[b] += found.direct[b];
  }
  tally.noteScore(r, replicate, found.largest);
  const double luminous = photometric(found.light, tally.bands());
  const double whole = luminous / static_cast<double>(this->Covered[r]);
  check.sum += luminous;
  check.beyond += luminous - whole;
  check.curved += 4.0 / 3 * (whole - found.halfRadius / static_cast<double>(this->HalfCovered[r]));
}

bool PhotonMap::trusts(std::size_t receiver, long long /*trajectories*/) const
{
  return this->Direct.hasAllImages() && (this->Direct.complete() || this->Settings_.own.finalGather ||
                                         static_cast<double>(this->Covered[receiver]) > trustedCoverage);
}

void PhotonMap::exchange(const Ranks& ranks)
{
  ranks.exchange(this->Replicates, [this](int first, int last, const auto& visit) {
    for (std::size_t tile = 0; tile * this->Replicates < this->Checks.size(); ++tile)
      for (int replicate = first; replicate < last; ++replicate)
      {
        Check& check = this->Checks[tile * this->Replicates + replicate];
        for (double* value : {&check.sum, &check.beyond, &check.curved})
          visit(*value);
      }
  });
}

std::vector<AuditLine> PhotonMap::audit() const
{
  std::vector<AuditLine> lines = this->Direct.audit();
  if (this->Direct.complete() || this->Checks.empty())
    return lines;
  const MethodOptions& own = this->Settings_.own;
  const auto inAir = std::count(this->OnSurface.begin(), this->OnSurface.end(), 0);
  std::ostringstream choice, reason;
  choice << std::setprecision(3);
  if (own.photons)
    choice << "the nearest " << own.photons << " photons";
  else if (this->Settings_.epsilon > 0)
    choice << "a radius of " << this->Settings_.epsilon << " m";
  else
    choice << "a radius of " << this->radiusAfter(defaultTrajectories / std::max(1, this->Replicates)) << " m at "
           << defaultTrajectories << " trajectories, shrinking with their sixth root";
  choice << (own.coneFilter ? ", cone filter" : "");
  reason << (own.finalGather ? "seen by rays from the receivers; direct light is exact"
                             : "flux over the area of a disc; direct light is exact");
  if (inAir > 0 && !own.finalGather)
    reason << "; at " << inAir << " receivers in the air photons that cross a disc";
  lines.push_back({"photons", choice.str(), reason.str()});
  if (own.finalGather)
    return lines;
  std::vector<double> off(this->Replicates);
  double sum = 0, beyond = 0;
  for (std::size_t i = 0; i < this->Checks.size(); ++i)
  {
    sum += this->Checks[i].sum;
    beyond += this->Checks[i].beyond;
    off[i % this->Replicates] += this->Checks[i].beyond + this->Checks[i].curved;
  }
  const MeanAndError bias = summarise(off.data(), off.size());
  const double scale = sum > 0 ? 100 / (sum - beyond) : 0;
  std::ostringstream amount, parts;
  amount << std::showpos << std::setprecision(2) << scale * this->Replicates * bias.mean << " +- " << std::noshowpos
         << scale * this->Replicates * bias.standardError << " %";
  parts << std::showpos << std::setprecision(2) << "of the indirect light at surfaces: " << scale * beyond
        << " % by discs beyond edges, up to "
        << 100 * (static_cast<double>(*std::min_element(this->Covered.begin(), this->Covered.end())) - 1)
        << " % at one receiver; the rest by curvature, from discs of half the radius";
  lines.push_back({"bias", amount.str(), parts.str()});
  return lines;
}
}  // namespace kalos
