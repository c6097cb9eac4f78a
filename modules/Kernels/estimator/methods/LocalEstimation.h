// SPDX-License-Identifier: BSD-3-Clause
// Also known as: next event estimation from light paths; point detector (MCNP F5); instant radiosity (VPLs, Keller
// 1997).
//
// Method `local`, (E1): E(r) = E_direct(r) + sum of M_i G(r, y_i) V over the vertices of the trajectories, where M_i is
// the flux that vertex i reflects (for a glossy vertex, pi f times its incident flux). Unbiased. Its variance grows
// without bound towards concave edges and contacts. The method keeps this on purpose, as the reference to study. It
// misses light that reaches a receiver by a mirror, except the images of point luminaires; `compensated` gathers that
// light.
//
// The methods that regularize the kernel near the receiver (estimator/kernel/KernelRegularization.h) run on the same
// trajectories and report how much that changed the result.
#ifndef kalos_estimator_methods_LocalEstimation_h
#define kalos_estimator_methods_LocalEstimation_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/kernel/KernelRegularization.h"
#include "estimator/kernel/PairKernel.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tracing/EmissionPilot.h"
#include "estimator/tracing/Trajectories.h"

namespace kalos
{
class LocalEstimation : public Estimator
{
public:
  LocalEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t receiver, long long trajectories) const override;
  bool altersKernel() const override { return this->Alteration != nullptr; }
  std::vector<AuditLine> audit() const override;

private:
  void scoreVertices(std::size_t receiver, int replicate, const VertexSet& vertices, Tally& tally, double* sum) const;
  void alter(std::size_t receiver, int replicate, const VertexSet& vertices, PairBlock& block) const;

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  double CollisionsPerArea;                          // per trajectory and m2
  std::unique_ptr<KernelRegularization> Alteration;  // null: the plain kernel
  std::vector<double> NearKernel;                    // 1/m2, per receiver; with the plain kernel
};
}  // namespace kalos

#endif
