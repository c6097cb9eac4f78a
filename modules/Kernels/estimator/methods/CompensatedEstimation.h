// SPDX-License-Identifier: BSD-3-Clause
// Also known as: instant radiosity with bias compensation (Kollig and Keller 2004).
//
// Method `compensated`: bounded and unbiased, with no length to tune.
//
//   E = E_direct + sum of a(G) X  +  integral of (1 - a(G)) L cos(theta) d omega,   a(G) = 1/(1 + G/G*)
//
// Vertices score the first part; a is their MIS weight, and no score exceeds M G*. A few cosine-weighted rays from the
// receiver gather the second part. The luminance where they end is (M0 + rho E)/pi, by the same estimator
// (estimator/gathering/WavefrontGather.h). The balance heuristic gives G* = (trajectories x collision density per
// trajectory and m2) / (gather rays, each counted four times), with the density about the vertex from a pilot. Shadow
// rays go to vertices picked in proportion to their unshadowed scores, one for every sixteen. Receivers with no surface
// near in front take all light from the vertices (G* infinite), because the kernel is bounded there. Bias: none.
// Source: compensation of clamped virtual lights (Kollig and Keller 2004) with a smooth split.
#ifndef kalos_estimator_methods_CompensatedEstimation_h
#define kalos_estimator_methods_CompensatedEstimation_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/methods/BiasCompensation.h"
#include "estimator/methods/Estimator.h"
#include "estimator/tracing/EmissionPilot.h"

namespace kalos
{
class CompensatedEstimation : public Estimator
{
public:
  CompensatedEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t /*receiver*/, long long /*trajectories*/) const override
  {
    return this->Direct.hasAllImages();
  }
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  void persist(Archive& archive) override { this->Light.persist(archive); }
  std::vector<double> gatherRays() const override;
  std::vector<AuditLine> audit() const override;

private:
  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  BiasCompensation Light;
  std::vector<double> EdgeDistances;  // of Receivers
  int Replicates = 0;
};
}  // namespace kalos

#endif
