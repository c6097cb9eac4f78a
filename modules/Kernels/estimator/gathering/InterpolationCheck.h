// SPDX-License-Identifier: BSD-3-Clause
// Measures the bias of final gathering: what sharing an estimate among the hits of a cell changes.
//
// One shared hit in `checkEvery` is also estimated at its own position. The mean difference is reported with its
// standard error.
#ifndef kalos_estimator_gathering_InterpolationCheck_h
#define kalos_estimator_gathering_InterpolationCheck_h

#include "estimator/control/Archive.h"
#include "estimator/control/Ranks.h"
#include "estimator/gathering/CellShading.h"

namespace kalos
{
class InterpolationCheck
{
public:
  /// Luminous sums over the rays of one replicate and tile.
  struct Sums
  {
    double excess = 0;  ///< of cells over estimates at the hits' own positions, lx
    double sum = 0;     ///< of all rays, lx
    double rays = 0, shared = 0;
    double cells = 0;  ///< of the whole replicate, with its first tile
  };

  void reset(std::size_t tiles, int replicates);
  bool empty() const { return this->All.empty(); }

  /// Different tiles and replicates may be written by different threads.
  Sums& of(std::size_t tile, int replicate) { return this->All[tile * this->Replicates + replicate]; }

  /// Fetches from every rank the sums of the replicates that it owns.
  void exchange(const Ranks& ranks);
  void persist(Archive& archive) { archive.array(this->All); }

  /// How many rays share cells, and the bias that this has.
  std::vector<AuditLine> audit() const;

private:
  int Replicates = 0;
  std::vector<Sums> All;  // by tile and replicate
};

/// Collects the hits of one tile that are estimated twice.
class InterpolationProbes
{
public:
  InterpolationProbes(const GatherContext& gathering, const CellShading& cells, InterpolationCheck::Sums& sums)
      : Rays(gathering), Cells(cells), Sums(sums)
  {
  }

  /// Notes a hit; `taken` is the sum of the weights with which receivers take its light.
  void note(const SurfaceHit& hit, double taken);

  /// Estimates the collected hits at their own positions and adds the differences to the sums.
  void finish();

private:
  struct Probe
  {
    const SurfaceHit* hit;
    double taken;
  };

  const GatherContext& Rays;
  const CellShading& Cells;
  InterpolationCheck::Sums& Sums;
  std::vector<Probe> Probes;
};
}  // namespace kalos

#endif
