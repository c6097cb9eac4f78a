// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/HitAccumulation.h"

#include <limits>

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;
}

void HitAccumulation::add(std::size_t tile, const GatherHits& gathered, const CellShading& cells, Tally& tally,
                          InterpolationCheck::Sums& sums) const
{
  const GatherRound& round = cells.round();
  const std::uint64_t seed = mixBits(round.seed + tile + 1);
  InterpolationProbes probes(this->Rays, cells, sums);
  DirectLight::Sample luminaires[width];  // of up to 16 hits, possibly of different receivers
  Sensor at[width];
  std::size_t i = 0, g = 0;
  for (const ReceiverGroup& group : this->Plan.groups(tile, tally))
  {
    GroupLight found;
    found.rays = this->Plan.raysPerTrajectory(group, round);
    for (const std::size_t end = gathered.ends[g++]; i < end; ++i)
    {
      const SurfaceHit& hit = gathered.hits[i];
      if (i % width == 0)
      {
        // Each hit draws its own luminaire; the hits of a packet share one random stream.
        SampleStream random(Sampling::Independent, seed, static_cast<std::uint64_t>(round.replicate), Purpose::Gather,
                            i);
        const int count = static_cast<int>(std::min<std::size_t>(width, gathered.hits.size() - i));
        for (int k = 0; k < count; ++k)
          at[k] = sensorAt(this->Rays.scene(), (&hit)[k]);
        const bool afar = std::none_of(&hit, &hit + count, [](const SurfaceHit& h) { return h.near; });
        this->Rays.luminaireLight(at, count, afar, random, luminaires);
      }
      const HitLight light = this->lightOf(hit, at[i % width], luminaires[i % width], cells);
      probes.note(hit, this->addHit(hit, at[i % width], light, group, found));
    }
    sums.sum += found.all;
    sums.rays += static_cast<double>(group.size()) * this->Plan.raysOfEach(group, round.rays);
    this->store(group, found, round, tally);
  }
  probes.finish();
}

HitAccumulation::HitLight HitAccumulation::lightOf(const SurfaceHit& hit, const Sensor& at,
                                                   const DirectLight::Sample& luminaires,
                                                   const CellShading& cells) const
{
  const Scene& scene = this->Rays.scene();
  const Material& material = scene.material(hit.side / 2);
  const bool lit = luminaires.light[0] > 0;
  const double* indirect = cells.indirect(hit);
  HitLight light;
  if (this->Spots.any())
  {
    const double density = this->Rays.vertexDensity(at);
    light.split[0] = this->Spots.split(density);
    if (hit.side & 1)
      light.split[1] = this->Spots.split(this->Rays.pilot().startDensity(material));
    if (lit)
      light.split[2] = this->Spots.split(std::max(density, this->Rays.firstHitDensity(at, luminaires.luminaire)));
    light.isSplit = light.split[0].isShared() || light.split[1].isShared() || light.split[2].isShared();
  }
  light.parts = light.isSplit && lit ? 3 : 2;
  const Bands mirrored = this->Rays.mirrored().any() ? this->Rays.mirrored().illuminance(at) : Bands{};
  for (int b = 0; b < scene.bands(); ++b)
  {
    light.part[0][b] = material.reflectance[b] * (indirect[b] + mirrored[b]);
    light.part[1][b] = hit.side & 1 ? material.exitance[b] : 0;
    light.part[light.parts == 3 ? 2 : 0][b] += material.reflectance[b] * luminaires.light[b];
  }
  for (int p = 0; p < light.parts; ++p)
    light.luminous[p] = photometric(light.part[p], scene.bands());
  light.picks.add(cells.picks(hit), photometric(material.reflectance, scene.bands()));
  return light;
}

// Returns the sum of all receivers' MIS weights for the indirect light of the hit.
double HitAccumulation::addHit(const SurfaceHit& hit, const Sensor& at, const HitLight& light,
                               const ReceiverGroup& group, GroupLight& found) const
{
  const Scene& scene = this->Rays.scene();
  const ReceiverGroup::Shares shares =
      group.share(at, hit.finder, hit.near, this->Rays.shadows() ? &scene.rays() : nullptr);
  double taken = 0;
  for (int k = 0; k < group.size(); ++k)
  {
    const auto share = static_cast<double>(shares.share[k]);
    if (share == 0)
      continue;
    double weight[HitLight::mostParts] = {share, share, share}, all = 0;
    for (int p = 0; light.isSplit && p < light.parts; ++p)
      weight[p] *= light.split[p].gathered(static_cast<double>(shares.kernel[k]), found.rays);
    if (this->Direct.exactMeshes(group.receiver(k)))
      weight[1] = 0;
    for (int p = 0; p < light.parts; ++p)
    {
      all += weight[p] * light.luminous[p];
      for (int b = 0; b < scene.bands(); ++b)
        found.sum[k][b] += weight[p] * light.part[p][b];
    }
    for (int b = 0; b < scene.bands(); ++b)
      found.emission[k][b] += weight[1] * light.part[1][b];
    found.largest[k] =
        all >= 0 ? std::max(found.largest[k], all) : std::numeric_limits<double>::quiet_NaN();  // a NaN stays
    found.all += all;
    found.picks[k].add(light.picks, weight[0]);
    taken += weight[0];
  }
  return taken;
}

void HitAccumulation::store(const ReceiverGroup& group, const GroupLight& found, const GatherRound& round,
                            Tally& tally) const
{
  const double weight = static_cast<double>(round.pool.trajectories) / this->Plan.raysOfEach(group, round.rays);
  for (int k = 0; k < group.size(); ++k)
  {
    const std::size_t r = group.receiver(k);
    tally.noteScore(r, round.replicate, weight * found.largest[k]);
    tally.picks(r, round.replicate).add(found.picks[k], weight);
    for (int b = 0; b < tally.bands(); ++b)
    {
      tally.total(r, round.replicate)[b] += weight * found.sum[k][b];
      tally.direct(r, round.replicate)[b] += weight * found.emission[k][b];
    }
  }
}
}  // namespace kalos
