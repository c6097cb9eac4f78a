// SPDX-License-Identifier: BSD-3-Clause
// What gather rays need of the scene: vertices, their density and the luminaires. estimator/gathering/WavefrontGather.h
// traces the rays.
#ifndef kalos_estimator_gathering_GatherContext_h
#define kalos_estimator_gathering_GatherContext_h

#include "estimator/control/Settings.h"
#include "estimator/control/Workers.h"
#include "estimator/direct/DirectLight.h"
#include "estimator/direct/MirrorImages.h"
#include "estimator/tracing/VertexDensity.h"

namespace kalos
{
/// The vertices of one replicate's round, annotated by the pilot, as gather rays use them.
struct GatherPool
{
  const LightVertices* vertices = nullptr;
  int trajectories = 0;  ///< that left them
};

class GatherContext
{
public:
  GatherContext(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows);

  const Scene& scene() const { return this->Scene_; }
  const VertexDensity& pilot() const { return this->Density; }
  const DirectLight& luminaires() const { return this->Luminaires; }
  const MirrorImages& mirrored() const { return this->Mirrored; }
  bool shadows() const { return this->Shadows; }
  /// Whether one vertex of a block is picked for the shadow ray, instead of all.
  bool picksVertices() const { return this->Shadows && !this->EveryPair; }
  bool shadowsEveryPair() const { return this->EveryPair; }

  /// Turns vertices off: longer paths find all light (estimator/methods/StrategyTrial.h). With `nextEvents` the starts
  /// of trajectories on emitting meshes still score where paths go: next event estimation.
  void usePathsOnly(bool nextEvents = false)
  {
    this->PathsOnly = true;
    this->Starts = nextEvents;
  }
  bool pathsOnly() const { return this->PathsOnly; }
  bool usesStarts() const { return this->Starts; }

  /// The vertices of trajectories [first, first + count) of every replicate, annotated by the pilot; of a sixteenth of
  /// them when pathsOnly(), for the energy balance. None when aborted.
  std::vector<LightVertices> trace(const Emission& emission, const Walks& walks, int replicates, long long first,
                                   int count, Workers& workers) const;

  /// Gather rays per trajectory, as they count for G*, of a ray beside a block of vertices; infinite when pathsOnly().
  double blockShare(int trajectories, int blockSize) const;

  /// The same beside a block of starts on emitting meshes; infinite unless usesStarts().
  double startShare(int trajectories, int blockSize) const;

  /// Densities that MIS weights are formed with, per m2 and trajectory: of light vertices about a sensor, by the pilot,
  /// and of those that have the direct light of a luminaire. The pilot misses the bright spots of weak luminaires.
  double vertexDensity(const Sensor& at) const { return this->Density.density(at.position); }
  double firstHitDensity(const Sensor& at, std::size_t luminaire) const
  {
    return this->Source.firstHitDensity(luminaire, at.position, at.normal);
  }

  /// The MIS weight of gather rays for the direct light of a luminaire over that for other light, where the latter is
  /// formed with `ratio` = G/G*: the vertices of the luminaire may be denser than the pilot says.
  double luminaireShare(const Sensor& at, std::size_t luminaire, double ratio) const;

  /// All light of luminaires at a sensor: direct, with one shadow ray, and by mirrors.
  Bands luminaireLight(const Sensor& sensor, SampleStream& random) const;

  /// The direct light of one luminaire that is drawn at each of up to SegmentPacket::width sensors without BRDF, with
  /// one shadow ray. In single precision where `afar`: see DirectLight.
  void luminaireLight(const Sensor* sensors, int count, bool afar, SampleStream& random,
                      DirectLight::Sample* samples) const;

private:
  const Scene& Scene_;
  const Emission& Source;
  VertexDensity Density;
  bool Shadows, EveryPair, PathsOnly = false, Starts = true;
  DirectLight Luminaires;
  MirrorImages Mirrored;
};
}  // namespace kalos

#endif
