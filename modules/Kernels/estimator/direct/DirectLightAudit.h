// SPDX-License-Identifier: BSD-3-Clause
// What the audit says about direct light: what is exact, what is sampled, and why.
#ifndef kalos_estimator_direct_DirectLightAudit_h
#define kalos_estimator_direct_DirectLightAudit_h

#include <vector>

#include "estimator/control/Result.h"
#include "estimator/direct/MirrorImages.h"
#include "scene/SceneNeeds.h"

namespace kalos
{
/// How the light of emitting meshes reaches the receivers.
enum class EmittingMeshes
{
  ClosedForms,
  MetByPaths,          ///< rays from the receivers hit them
  SampledAsRequested,  ///< trajectories start on them, because closed forms are disabled
  TooMany              ///< trajectories start on them, because there are too many for closed forms
};

struct DirectLightChoices
{
  const Scene& scene;
  const SceneNeeds& needs;
  const std::vector<Sensor>& sensors;
  const MirrorImages& mirrors;
  EmittingMeshes meshes;
};
std::vector<AuditLine> auditDirectLight(const DirectLightChoices& choices);
}  // namespace kalos

#endif
