// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/InterpolationCheck.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "photometry/Bands.h"
#include "statistics/Replicates.h"

namespace kalos
{
namespace
{
constexpr int checkEvery = 64;  // shared hits
}

void InterpolationCheck::reset(std::size_t tiles, int replicates)
{
  this->Replicates = replicates;
  this->All.assign(tiles * replicates, {});
}

void InterpolationCheck::exchange(const Ranks& ranks)
{
  ranks.exchange(this->Replicates, [this](int first, int last, const auto& visit) {
    for (std::size_t tile = 0; tile * this->Replicates < this->All.size(); ++tile)
      for (int replicate = first; replicate < last; ++replicate)
      {
        Sums& sums = this->of(tile, replicate);
        for (double* value : {&sums.excess, &sums.sum, &sums.rays, &sums.shared, &sums.cells})
          visit(*value);
      }
  });
}

std::vector<AuditLine> InterpolationCheck::audit() const
{
  std::vector<double> excess(this->Replicates);
  double rays = 0, shared = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    rays += this->All[i].rays;
    shared += this->All[i].shared;
    sum += this->All[i].sum;
    count += this->All[i].cells;
    excess[i % this->Replicates] += this->All[i].excess;
  }
  const MeanAndError bias = summarise(excess.data(), excess.size());
  const double scale = sum > 0 ? 100 * this->Replicates / sum : 0;
  std::ostringstream cells, share, amount;
  cells << std::setprecision(3) << rays / std::max(1.0, count) << " gather rays per cell";
  share << std::setprecision(3) << 100 * shared / std::max(1.0, rays)
        << " % of the rays share an estimate with others; cells are as wide as a share of the viewing distance";
  amount << std::showpos << std::setprecision(2) << scale * bias.mean << " +- " << std::noshowpos
         << scale * bias.standardError << " %";
  return {{"cells", cells.str(), share.str()},
          {"bias", amount.str(), "of the gathered light, measured by rays that share no estimate"}};
}

void InterpolationProbes::note(const SurfaceHit& hit, double taken)
{
  if (!this->Cells.isShared(hit))
    return;
  this->Sums.shared += 1;
  if (static_cast<long long>(this->Sums.shared) % checkEvery == checkEvery / 2)
    this->Probes.push_back({&hit, taken});
}

void InterpolationProbes::finish()
{
  const Scene& scene = this->Rays.scene();
  WavefrontGather wave(this->Rays, this->Cells.round().pool);
  for (const Probe& probe : this->Probes)
    this->Cells.estimate(*probe.hit, wave);
  wave.run();
  double excess = 0;
  for (std::size_t i = 0; i < this->Probes.size(); ++i)
  {
    const SurfaceHit& hit = *this->Probes[i].hit;
    const Material& material = scene.material(hit.side / 2);
    Bands difference;
    for (int b = 0; b < scene.bands(); ++b)
      difference[b] = material.reflectance[b] * (this->Cells.indirect(hit)[b] - wave.light(i)[b]);
    excess += this->Probes[i].taken * photometric(difference, scene.bands());
  }
  this->Sums.excess += checkEvery * excess;
  this->Probes.clear();
}
}  // namespace kalos
