// SPDX-License-Identifier: BSD-3-Clause
// Lights a tile of receivers by the hits of its gather rays; see estimator/methods/FinalGathering.h.
#include "estimator/methods/FinalGathering.h"

#include <limits>

namespace kalos
{
namespace
{
constexpr int width = SegmentPacket::width;
constexpr int checkEvery = 64;  // one of so many shared hits is also estimated at its own position
}  // namespace

void FinalGathering::lightByLamps(const SurfaceHit* hits, const Sensor* at, int count, SampleStream& random,
                                  Bands* light) const
{
  // Packet rays start at an offset above the surface. Where a hit is too near for that offset, use single rays.
  if (std::none_of(hits, hits + count, [](const SurfaceHit& hit) { return hit.near; }))
    return this->Rays.luminaireLight(at, count, random, light);
  for (int i = 0; i < count; ++i)
    light[i] = this->Rays.luminaireLight(at[i], random);
}

void FinalGathering::collect(std::size_t tile, int replicate, const Replicate& round, int rays,
                             const GatherHits& gathered, Tally& tally, Check& check) const
{
  const int bands = tally.bands();
  const std::uint64_t seed = mixBits(this->seedOfCells(replicate) + tile + 1);
  const RayScene* shadows = this->Rays.shadows() ? &this->Scene_.rays() : nullptr;
  std::vector<Probe> checked;
  Bands lamps[width];  // of up to 16 hits, possibly of different receivers
  Sensor at[width];
  std::size_t i = 0, g = 0;
  for (const ReceiverGroup& group : this->groups(tile, tally))
  {
    Bands sum[width] = {}, emission[width] = {};
    double largest[width] = {};
    for (const std::size_t end = gathered.ends[g++]; i < end; ++i)
    {
      const SurfaceHit& hit = gathered.hits[i];
      if (i % width == 0)
      {
        // Each hit draws its own luminaire; the hits of a packet share one random stream.
        SampleStream random(Sampling::Independent, seed, static_cast<std::uint64_t>(replicate), Purpose::Gather, i);
        const int count = static_cast<int>(std::min<std::size_t>(width, gathered.hits.size() - i));
        for (int k = 0; k < count; ++k)
          at[k] = this->at((&hit)[k]);
        this->lightByLamps(&hit, at, count, random, lamps);
      }
      float shares[ReceiverGroup::capacity];
      group.share(at[i % width], hit.finder, hit.near, shadows, shares);
      const Material& material = this->Scene_.material(hit.side / 2);
      const double* e = &round.indirect[hit.cell * bands];
      Bands reflected, emitted;
      for (int b = 0; b < bands; ++b)
      {
        emitted[b] = hit.side & 1 ? material.exitance[b] : 0;
        reflected[b] = material.reflectance[b] * (lamps[i % width][b] + e[b]);
      }
      const double luminous[2] = {photometric(reflected, bands), photometric(emitted, bands)};
      double taken = 0;
      for (int k = 0; k < group.size(); ++k)
      {
        const double share = shares[k];
        if (share == 0)
          continue;
        const bool exactMeshes = this->Direct.exactMeshes(group.receiver(k));
        taken += share;
        for (int b = 0; b < bands; ++b)
        {
          const double m = exactMeshes ? 0 : share * emitted[b];
          emission[k][b] += m;
          sum[k][b] += m + share * reflected[b];
        }
        const double all = share * (luminous[0] + (exactMeshes ? 0 : luminous[1]));
        largest[k] = all >= 0 ? std::max(largest[k], all) : std::numeric_limits<double>::quiet_NaN();  // a NaN stays
        check.sum += all;
      }
      if (round.grid.cells()[hit.cell].hits < 2)
        continue;
      check.shared += 1;
      if (static_cast<long long>(check.shared) % checkEvery == checkEvery / 2)
        checked.push_back({&hit, taken});
    }
    const int each = this->raysOfEach(group, rays);
    const double weight = static_cast<double>(round.pool.trajectories) / each;
    for (int k = 0; k < group.size(); ++k)
    {
      const std::size_t r = group.receiver(k);
      check.rays += each;
      tally.noteScore(r, replicate, weight * largest[k]);
      for (int b = 0; b < bands; ++b)
      {
        tally.total(r, replicate)[b] += weight * sum[k][b];
        tally.direct(r, replicate)[b] += weight * emission[k][b];
      }
    }
  }
  check.excess += checkEvery * this->excess(checked, replicate, round);
}

double FinalGathering::excess(const std::vector<Probe>& probes, int replicate, const Replicate& round) const
{
  WavefrontGather wave(this->Rays, round.pool);
  for (const Probe& probe : probes)
    this->estimate(*probe.hit, replicate, wave);
  wave.run();
  const int bands = this->Scene_.bands();
  double excess = 0;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    const SurfaceHit& hit = *probes[i].hit;
    const Material& material = this->Scene_.material(hit.side / 2);
    Bands difference;
    for (int b = 0; b < bands; ++b)
      difference[b] = material.reflectance[b] * (round.indirect[hit.cell * bands + b] - wave.light(i)[b]);
    excess += probes[i].taken * photometric(difference, bands);
  }
  return excess;
}
}  // namespace kalos
