// SPDX-License-Identifier: BSD-3-Clause
// Also known as: backward ray tracing; unidirectional path tracing with next event estimation (Kajiya 1986), as in
// Mitsuba's `path` and Radiance's `rtrace` without its cache.
//
// Method `paths`: one path per trajectory starts at each receiver, in a cosine-weighted direction.
//
//   E = E_direct + mean over the paths of  sum over bounces k of  rho_1 ... rho_k (E_luminaires + E_meshes)(x_k)
//
// At each bounce x_k one shadow ray goes to a luminaire and one to an emitting mesh; a mesh that the path meets by
// itself is weighed against the latter by the balance heuristic. Ended by Russian roulette on the throughput. Bias:
// none. No vertices of trajectories enter, so that this is a judge of the methods that use them; a path needs luck to
// find light that reaches its surface through a small opening or by a mirror.
#ifndef kalos_estimator_methods_PathTracing_h
#define kalos_estimator_methods_PathTracing_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/direct/ReceiverDirectLight.h"
#include "estimator/gathering/GatherContext.h"
#include "estimator/methods/Estimator.h"

namespace kalos
{
class PathTracing : public Estimator
{
public:
  PathTracing(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
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
  // The starts of trajectories [first, first + count) on emitting meshes, for next event estimation.
  bool drawStarts(long long first, int count, std::vector<LightVertices>& pools, Workers& workers) const;

  Settings Settings_;
  Emission Source;
  ReceiverDirectLight Direct;
  GatherContext Rays;
};
}  // namespace kalos

#endif
