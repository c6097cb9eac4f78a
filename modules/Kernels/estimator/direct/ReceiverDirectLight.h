// SPDX-License-Identifier: BSD-3-Clause
// The receivers of a solve as sensors, and their direct light, for the methods with exact direct light.
#ifndef kalos_estimator_direct_ReceiverDirectLight_h
#define kalos_estimator_direct_ReceiverDirectLight_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/control/Workers.h"
#include "estimator/direct/DirectLight.h"
#include "estimator/direct/Highlights.h"
#include "estimator/direct/MirrorImages.h"
#include "estimator/tally/Tally.h"
#include "scene/SceneNeeds.h"

namespace kalos
{
class ReceiverDirectLight
{
public:
  /// The sampled part takes one sample per `trajectoriesPerSample` trajectories of a round; eight times fewer where a
  /// receiver and its neighbours in order saw all of the emitters or none of them in a pilot. `withHighlights`: samples
  /// highlights, for methods whose vertices and gather rays leave them out (Sensor::highlightsApart).
  ReceiverDirectLight(const Scene& scene, const Receivers& receivers, const Settings& settings, bool withHighlights,
                      int trajectoriesPerSample = 4);

  const std::vector<Sensor>& sensors() const { return this->Sensors; }
  bool shadows() const { return !this->Needs.unoccluded; }

  /// False when the starts of trajectories on emitting meshes must score at this receiver: there are too many emitting
  /// triangles for closed forms, or the receiver is glossy.
  bool exactMeshes(std::size_t receiver) const { return this->ClosedForms && !this->Sensors[receiver].brdf; }

  /// Excludes emitting meshes from now on: rays from the receivers hit them.
  void leaveMeshesToRays()
  {
    this->ClosedForms = false;
    this->MeshesSeen = true;
  }

  /// lx, photometric, of what prepare() has found of direct light; 0 at a receiver with a BRDF.
  double illuminance(std::size_t receiver) const;

  /// Whether no important mirror image of a point luminaire is left out: see MirrorImages::truncated().
  bool hasAllImages() const { return !this->Mirrored.truncated(); }

  /// Whether there is no other light: nothing reflects, and all emission has a closed form.
  bool complete() const { return !this->Needs.reflects && this->ClosedForms; }

  /// Fills the fixed part of the tally: direct light in closed form. Returns false when aborted.
  bool prepare(Workers& workers, Tally& tally);

  /// The sampled part, for a round of `count` trajectories; lx times `count`, per band.
  Bands fluctuation(std::size_t receiver, int replicate, long long first, int count) const;

  /// Adds the sampled part, for a round of trajectories [first, first + count): the visibility of area emitters, or the
  /// whole direct light of a glossy receiver. Skips receivers that reached the goal.
  void score(std::size_t receiver, int replicate, long long first, int count, Tally& tally) const;

  /// score() for all receivers and replicates; false when aborted.
  bool scoreAll(long long first, int count, Workers& workers, Tally& tally) const;

  std::vector<AuditLine> audit() const;

private:
  const DirectLight& direct() const { return this->ClosedForms ? this->Exact : this->Luminaires; }
  Bands highlights(std::size_t receiver, int replicate, long long first, int count) const;
  void measureVisibility(std::size_t receiver);
  bool isSteady(std::size_t receiver) const;

  const Scene& Scene_;
  int PerSample;
  Walks Drawn;
  bool Sampled;  // no closed forms of areas
  SceneNeeds Needs;
  bool ClosedForms, MeshesSeen = false;
  DirectLight Exact;       // luminaires, and meshes where closed forms serve
  DirectLight Luminaires;  // luminaires only
  MirrorImages Mirrored;
  Highlights Lobes;
  std::vector<Sensor> Sensors;
  std::vector<DirectLight::View> Views;
};
}  // namespace kalos

#endif
