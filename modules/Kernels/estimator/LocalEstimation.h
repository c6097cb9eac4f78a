// SPDX-License-Identifier: BSD-3-Clause
// Method `local`, (E1): E(r) = E_direct(r) + sum of M_i G(r, y_i) V over the vertices of the trajectories, where M_i is
// the flux that vertex i reflects (for a glossy vertex, pi f times its incident flux). Unbiased; its variance grows
// without bound towards concave edges and contacts, and this is kept as it is: it is what one studies.
// Light that a receiver sees in a mirror comes from no vertex in view and is not found, but for the images of point
// luminaires; `compensated` gathers it.
//
// The methods that alter the kernel near the receiver (estimator/KernelAlteration.h) run on the same trajectories and
// report how much the alteration added.
#ifndef kalos_estimator_LocalEstimation_h
#define kalos_estimator_LocalEstimation_h

#include "estimator/DirectPart.h"
#include "estimator/Estimator.h"
#include "estimator/KernelAlteration.h"
#include "estimator/PairKernel.h"
#include "estimator/Trajectories.h"

namespace kalos
{
class LocalEstimation : public Estimator
{
public:
  LocalEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool letsRest() const override { return true; }
  bool trusts(std::size_t receiver, long long trajectories) const override;
  bool altersKernel() const override { return this->Alteration != nullptr; }
  std::vector<AuditLine> audit() const override;

private:
  void scoreVertices(std::size_t receiver, int replicate, const VertexSet& vertices, Tally& tally, double* sum) const;
  void alter(std::size_t receiver, int replicate, const VertexSet& vertices, PairBlock& block) const;

  const Scene& Lit;
  Settings Wanted;
  Emission Source;
  DirectPart Direct;
  double CollisionsPerArea;                      // per trajectory and m2
  std::unique_ptr<KernelAlteration> Alteration;  // null: the plain kernel
  std::vector<double> NearKernel;                // 1/m2, per receiver; with the plain kernel
};
}  // namespace kalos

#endif
