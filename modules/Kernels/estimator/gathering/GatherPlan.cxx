// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/GatherPlan.h"

#include <algorithm>
#include <cmath>

namespace kalos
{
namespace
{
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

GatherPlan::GatherPlan(const Scene& scene, const std::vector<Sensor>& sensors, const Settings& settings)
    : Sensors(sensors),
      Seed(settings.seed),
      OwnRays(!settings.uses(Technique::Neighbours)),
      MostlyDiffuse(isMostlyDiffuse(scene)),
      Order(orderOf(sensors))
{
}

int GatherPlan::trajectoriesPerRay() const
{
  constexpr int unshared = 32, least = 16, most = 256;
  if (!this->sharesRays())
    return unshared;
  int each = least;
  while (each < most && static_cast<double>(each) * each < 8 * static_cast<double>(this->Order.size()))
    each *= 2;
  return each;
}

GatherRound GatherPlan::round(const GatherPool& pool, int replicate, long long raysDone, std::size_t active) const
{
  const int each = this->trajectoriesPerRay(), rays = (pool.trajectories + each - 1) / each;
  const std::uint64_t seed = mixBits(mixBits(this->Seed + 0x5eed) + static_cast<std::uint64_t>(replicate)) +
                             mixBits(static_cast<std::uint64_t>(raysDone));
  return {pool, replicate, raysDone, rays, cellShare(rays, active), seed};
}

std::vector<std::size_t> GatherPlan::activeIn(std::size_t tile, const Tally& tally, bool shares) const
{
  std::vector<std::size_t> found;
  for (std::size_t i = tile * tileSize; i < std::min(this->Order.size(), (tile + 1) * tileSize); ++i)
  {
    const std::size_t r = this->Order[i];
    const Sensor& sensor = this->Sensors[r];
    if (!tally.converged(r) && shares == !(sensor.brdf || sensor.anchor.crowded))
      found.push_back(r);
  }
  return found;
}

std::vector<ReceiverGroup> GatherPlan::groups(std::size_t tile, const Tally& tally) const
{
  std::vector<ReceiverGroup> found;
  for (const std::size_t r : this->activeIn(tile, tally, true))
  {
    if (found.empty() || found.back().size() == this->groupSize())
      found.emplace_back();
    found.back().add(r, this->Sensors[r]);
  }
  return found;
}

std::vector<std::size_t> GatherPlan::loners(std::size_t tile, const Tally& tally) const
{
  return this->activeIn(tile, tally, false);
}

int GatherPlan::raysOfEach(const ReceiverGroup& group, int rays) const
{
  int size = 1;
  while (size < group.size())
    size *= 2;
  return rays * this->groupSize() / size;
}

double GatherPlan::raysPerTrajectory(const ReceiverGroup& group, const GatherRound& round) const
{
  constexpr double worth = 4;  // as in BiasCompensation
  return worth * group.size() * this->raysOfEach(group, round.rays) / round.pool.trajectories;
}

AuditLine GatherPlan::audit() const
{
  if (this->sharesRays())
    return {"neighbours", "groups of " + std::to_string(ReceiverGroup::capacity),
            "a hit of one receiver's gather ray also lights the others, with one shadow ray each"};
  return {"neighbours", "each by itself",
          this->OwnRays     ? "as requested"
          : this->PathsOnly ? "luminous surfaces are all around: unshared rays take less time"
                            : "most surfaces are glossy: their luminance depends on the viewer"};
}
}  // namespace kalos
