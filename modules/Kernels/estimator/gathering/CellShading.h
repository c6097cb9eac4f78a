// SPDX-License-Identifier: BSD-3-Clause
// Also known as: an irradiance cache of gather hits, filled on demand.
//
// The cells of one replicate's gather hits and the indirect illuminance of each. One hit of each cell, drawn uniformly,
// gets an unbiased estimate: by a block of vertices, and a gather ray for the part that vertices leave
// (WavefrontGather::indirectLight).
#ifndef kalos_estimator_gathering_CellShading_h
#define kalos_estimator_gathering_CellShading_h

#include "estimator/gathering/GatherHitGrid.h"
#include "estimator/gathering/GatherPlan.h"
#include "estimator/gathering/WavefrontGather.h"

namespace kalos
{
class CellShading
{
public:
  CellShading(const GatherContext& gathering, const GatherRound& round) : Rays(gathering), Round(round) {}

  /// Sorts hits into cells. The order of hits must not depend on threads.
  void add(std::vector<SurfaceHit>& hits);

  /// Makes room for the estimates. Call after the last add() and before the first shade().
  void reserve();

  /// Estimates the cells of one part. Parts may be shaded by different threads.
  void shade(std::size_t part);
  std::size_t parts() const;

  /// Frees the cells.
  void clear();

  const GatherRound& round() const { return this->Round; }
  std::size_t cells() const { return this->Grid.cells().size(); }

  /// Whether other hits share the estimate of this one.
  bool isShared(const SurfaceHit& hit) const { return this->Grid.cells()[hit.cell].hits > 1; }

  /// The indirect illuminance in the cell of a hit, lx per band.
  const double* indirect(const SurfaceHit& hit) const;

  /// What picks of vertices for the cell of a hit have seen, lx.
  const PickCount& picks(const SurfaceHit& hit) const { return this->Picked[hit.cell]; }

  /// Adds an estimate at the hit's own position to a wave.
  void estimate(const SurfaceHit& hit, WavefrontGather& wave) const;

private:
  const GatherContext& Rays;
  GatherRound Round;
  GatherHitGrid Grid;
  std::vector<double> Indirect;   // lx, by cell and band
  std::vector<PickCount> Picked;  // by cell
};

/// A sensor where a gather ray has hit, on the side that it met.
Sensor sensorAt(const Scene& scene, const SurfaceHit& hit);
}  // namespace kalos

#endif
