// SPDX-License-Identifier: BSD-3-Clause
// Also known as: bidirectional path tracing (Lafortune and Willems 1993, Veach and Guibas 1994).
//
// Method `bidirectional`: the trajectories of a round and as many paths of each receiver, in pairs, are joined in all
// ways, a shadow ray each, weighed by the balance heuristic (estimator/methods/BidirectionalPath.h):
//
//   E = E_direct + mean over i of  sum over m, j of  w  T_m f(x_m) G(x_m, z_j) V f(z_j) W_j
//
// with T_m the throughput of the receiver's half up to x_m (x_0 is the receiver) and W_j the flux that arrives at
// vertex z_j of the trajectory (z_0 is the emitter). MethodOptions::connections takes a single column of that table: 1
// local estimates, 2 double ones, 3 triple ones, ... of paths that are long enough, else the longest that there is.
// Direct light is exact. Bias: none. Each alone is what the literature compares; all together are bounded at edges.
#ifndef kalos_estimator_methods_Bidirectional_h
#define kalos_estimator_methods_Bidirectional_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/methods/BidirectionalPath.h"
#include "estimator/methods/Estimator.h"
#include "scene/RayBatch.h"

namespace kalos
{
class Bidirectional : public Estimator
{
public:
  Bidirectional(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override { return this->Direct.prepare(workers, tally); }
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  bool skipsConverged() const override { return true; }
  bool trusts(std::size_t /*receiver*/, long long /*trajectories*/) const override
  {
    return this->Direct.hasAllImages();
  }
  int replicates(long long trajectories) const override { return fewReplicates(trajectories); }
  Pace pace() const override;
  std::vector<AuditLine> audit() const override;

private:
  // What one receiver gets from one pair of halves: contributions that a shadow ray decides on, and others.
  struct Scores
  {
    std::vector<ShadowRay> rays;
    std::vector<Bands> light;
    std::vector<char> direct;  // of each: straight from an emitter
    Bands sum{}, directSum{};
  };
  LightHalf traceLight(int replicate, long long i, EnergySums& energy) const;
  // Adds to `scores` what the half itself meets, too.
  std::vector<PathNode> traceReceiver(std::size_t r, int replicate, long long i, const LightHalf& light,
                                      Scores& scores) const;
  void meet(std::size_t r, const std::vector<PathNode>& nodes, const SurfacePoint& y, const LightHalf& light,
            Scores& scores) const;
  void join(std::size_t r, const std::vector<PathNode>& nodes, const LightHalf& light, Scores& scores) const;
  // The trajectories that the paths of a receiver are joined to, in an order of its own: points of one index in two
  // Sobol' sequences are not independent, however they are scrambled.
  std::vector<std::size_t> partners(std::size_t r, int replicate, long long first, int count) const;
  void scorePair(std::size_t r, int replicate, long long i, const LightHalf& light, Tally& tally) const;
  void joinOne(std::size_t r, const std::vector<PathNode>& nodes, std::size_t m, const LightHalf& light, std::size_t j,
               Scores& scores) const;

  const Scene& Scene_;
  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  DirectLight Luminaires;  // those seen by mirrors
};
}  // namespace kalos

#endif
