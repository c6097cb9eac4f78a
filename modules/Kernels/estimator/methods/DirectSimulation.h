// SPDX-License-Identifier: BSD-3-Clause
// Also known as: direct simulation; light tracing with photon counting on a cell.
//
// Method `direct`: the flux that trajectories bring to a receiver's cell, divided by the cell's area. The baseline for
// local estimation. Unbiased for the mean over the cell; the cell is not a point.
//
// A receiver without its own polygon gets a square of half side epsilon about its point (automatic: 1/200 of the
// scene's size).
#ifndef kalos_estimator_methods_DirectSimulation_h
#define kalos_estimator_methods_DirectSimulation_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tracing/Trajectories.h"

namespace kalos
{
class DirectSimulation : public Estimator
{
public:
  DirectSimulation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  std::vector<AuditLine> audit() const override;

private:
  void addCell(const std::vector<Vec3>& corners, std::uint32_t receiver);
  void score(const Segment& segment, int replicate, std::vector<std::uint32_t>& met, Tally& tally) const;

  const Scene& Scene_;
  Settings Settings_;
  double HalfSide;
  Emission Source;
  std::vector<Vec3> CellPoints;
  std::vector<Triangle> CellTriangles;
  std::vector<std::uint32_t> Owner;  // receiver of each cell triangle
  std::vector<double> CellAreas;     // per receiver, m2
  std::vector<Vec3> Normals;         // per receiver
  std::unique_ptr<RayScene> Cells;
};
}  // namespace kalos

#endif
