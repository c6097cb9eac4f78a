// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/HitAccumulation.h"

#include <limits>

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;
}

void HitAccumulation::lightByLuminaires(const SurfaceHit* hits, const Sensor* at, int count, SampleStream& random,
                                        Bands* light) const
{
  // Packet rays start at an offset above the surface. Where a hit is too near for that offset, use single rays.
  if (std::none_of(hits, hits + count, [](const SurfaceHit& hit) { return hit.near; }))
    return this->Rays.luminaireLight(at, count, random, light);
  for (int i = 0; i < count; ++i)
    light[i] = this->Rays.luminaireLight(at[i], random);
}

void HitAccumulation::add(std::size_t tile, const GatherHits& gathered, const CellShading& cells, Tally& tally,
                          InterpolationCheck::Sums& sums) const
{
  const GatherRound& round = cells.round();
  const std::uint64_t seed = mixBits(round.seed + tile + 1);
  InterpolationProbes probes(this->Rays, cells, sums);
  Bands luminaires[width];  // of up to 16 hits, possibly of different receivers
  Sensor at[width];
  std::size_t i = 0, g = 0;
  for (const ReceiverGroup& group : this->Plan.groups(tile, tally))
  {
    GroupLight found;
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
        this->lightByLuminaires(&hit, at, count, random, luminaires);
      }
      probes.note(hit, this->addHit(hit, at[i % width], luminaires[i % width], cells.indirect(hit), group, found));
    }
    sums.sum += found.all;
    sums.rays += static_cast<double>(group.size()) * this->Plan.raysOfEach(group, round.rays);
    this->store(group, found, round, tally);
  }
  probes.finish();
}

// Returns the sum of all receivers' MIS weights for the hit.
double HitAccumulation::addHit(const SurfaceHit& hit, const Sensor& at, const Bands& luminaires, const double* indirect,
                               const ReceiverGroup& group, GroupLight& found) const
{
  const Scene& scene = this->Rays.scene();
  const int bands = scene.bands();
  float shares[ReceiverGroup::capacity];
  if (hit.byLobe)
  {
    std::fill_n(shares, ReceiverGroup::capacity, 0.0f);
    shares[hit.finder] = hit.weight;
  }
  else
    group.share(at, hit.finder, hit.near, this->Rays.shadows() ? &scene.rays() : nullptr, shares);
  const Material& material = scene.material(hit.side / 2);
  Bands reflected, emitted;
  for (int b = 0; b < bands; ++b)
  {
    emitted[b] = hit.side & 1 ? material.exitance[b] : 0;
    reflected[b] = material.reflectance[b] * (luminaires[b] + indirect[b]);
  }
  const double luminous[2] = {photometric(reflected, bands), photometric(emitted, bands)};
  double taken = 0;
  for (int k = 0; k < group.size(); ++k)
  {
    if (shares[k] == 0)
      continue;
    const double share = shares[k];
    double diffuse = share;
    if (at.diffuseOf)
    {
      // A lobe's ray came from a surface and not from the receiver: the hit knows its direction.
      const Vec3 back = hit.byLobe ? Vec3{} : this->Direct.sensors()[group.receiver(k)].position - at.position;
      const double mu = hit.byLobe ? hit.cosine : dot(back, at.normal) / length(back);
      diffuse *= at.diffuseOf->diffuseTowards(mu);
    }
    const bool seesMeshes = hit.byLobe || !this->Direct.exactMeshes(group.receiver(k));
    taken += diffuse;
    for (int b = 0; b < bands; ++b)
    {
      const double m = seesMeshes ? share * emitted[b] : 0;
      found.emission[k][b] += hit.byLobe ? 0 : m;
      found.sum[k][b] += m + diffuse * reflected[b];
    }
    const double all = diffuse * luminous[0] + (seesMeshes ? share * luminous[1] : 0);
    found.largest[k] =
        all >= 0 ? std::max(found.largest[k], all) : std::numeric_limits<double>::quiet_NaN();  // a NaN stays
    found.all += all;
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
    for (int b = 0; b < tally.bands(); ++b)
    {
      tally.total(r, round.replicate)[b] += weight * found.sum[k][b];
      tally.direct(r, round.replicate)[b] += weight * found.emission[k][b];
    }
  }
}
}  // namespace kalos
