// SPDX-License-Identifier: BSD-3-Clause
// Method `gathered`: the fast one; consistent, with a bias that it measures and reports.
//
// First pass: what reaches the surfaces by reflection, on a cache of points (estimator/SurfaceCache.h) that the
// receivers were found to see, by the same vertices and gather rays as `compensated`. Second pass: stratified
// cosine-weighted rays from each receiver; where one ends, E = direct light of the luminaires there, with one shadow
// ray, + what the cache holds, and the receiver is lit by (M0 + rho E)/pi. Where a ray ends nearer than a cell, or on
// gloss or a mirror, or where the cache holds nothing, the unbiased gather ray of `compensated` takes its place.
//
// Bias: the cache's interpolation, second order in the cell. One cached ray in 32 is estimated without the cache too;
// the mean difference is the bias that audit() states with its standard error. Each replicate has values of its own in
// the cache, so that standard errors include the cache's noise. Source: radiosity with final gathering (Lischinski,
// Tampieri and Greenberg 1993), its radiosity estimated without bias.
#ifndef kalos_estimator_GatheredEstimation_h
#define kalos_estimator_GatheredEstimation_h

#include "estimator/CompensatedLight.h"
#include "estimator/DirectPart.h"
#include "estimator/Estimator.h"
#include "estimator/SurfaceCache.h"

namespace kalos
{
class GatheredEstimation : public Estimator
{
public:
  GatheredEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  int replicates(long long trajectories) const override;
  void exchange(const Ranks& ranks) override;
  void persist(Archive& archive) override;
  void exchangeState(const Ranks& ranks) override;
  std::vector<AuditLine> audit() const override;

private:
  // Luminous sums over the cached rays of one replicate and tile.
  struct Check
  {
    double excess = 0;  // of cached values over unbiased ones, lx
    double sum = 0;     // of all rays, lx
    long long rays = 0, cached = 0;
  };
  bool layCache(Workers& workers);
  bool fillCache(const Round& round, Workers& workers);
  void gather(std::size_t r, int replicate, const Round& round, Tally& tally, Check& check) const;
  bool fromCache(const SurfacePoint& y, int replicate, SampleStream& random, Bands& e) const;

  const Scene& Lit;
  Settings Wanted;
  Emission Source;
  DirectPart Direct;
  CompensatedLight Light;
  SurfaceCache Cache;
  std::vector<Sensor> CacheSensors;
  std::unique_ptr<Tally> Cached;  // sums over Trajectories trajectories of each replicate
  long long Trajectories = 0;
  std::vector<Check> Checks;  // per tile and replicate
  int Replicates = 0;
};
}  // namespace kalos

#endif
