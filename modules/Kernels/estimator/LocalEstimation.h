// SPDX-License-Identifier: BSD-3-Clause
// Method `local`, (E1): E(r) = E_direct(r) + sum of M_i G(r, y_i) V over the vertices of the trajectories, where M_i is
// the flux that vertex i reflects. Unbiased; its variance grows without bound towards concave edges and contacts, and
// this is kept as it is: it is what one studies.
#ifndef kalos_estimator_LocalEstimation_h
#define kalos_estimator_LocalEstimation_h

#include "estimator/DirectLight.h"
#include "estimator/Estimator.h"
#include "scene/Audit.h"

namespace kalos
{
class LocalEstimation : public Estimator
{
public:
  LocalEstimation(const Scene& scene, const Receivers& receivers, const Settings& settings);

  bool prepare(Workers& workers, Tally& tally) override;
  bool addRound(long long first, int count, Workers& workers, Tally& tally) override;
  std::vector<AuditLine> audit() const override;

private:
  void scoreVertices(const ReceiverPoint& receiver, const VertexSet& vertices, double* sum) const;
  void scoreHidden(std::size_t receiver, int replicate, long long first, int count, Tally& tally) const;

  const Scene& Lit;
  Settings Wanted;
  Audit Found;
  bool ExactMeshes;  // emitting meshes by closed form, not by the trajectories' starts
  Emission Source;
  DirectLight Direct;
  std::vector<ReceiverPoint> Points;
  std::vector<DirectLight::View> Views;
};
}  // namespace kalos

#endif
