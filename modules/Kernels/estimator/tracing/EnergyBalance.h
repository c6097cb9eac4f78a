// SPDX-License-Identifier: BSD-3-Clause
// Energy balance of the trajectories: emitted = absorbed + escaped, within error bars, in every run.
#ifndef kalos_estimator_tracing_EnergyBalance_h
#define kalos_estimator_tracing_EnergyBalance_h

#include "estimator/control/Archive.h"
#include "estimator/control/Ranks.h"
#include "estimator/control/Result.h"
#include "scene/Scene.h"

namespace kalos
{
/// Sums over trajectories, lm if each were the only one, and counts per surface.
class EnergySums
{
public:
  explicit EnergySums(std::size_t surfaces = 0) : Values(fixed + each * surfaces) {}

  double& emitted() { return this->Values[0]; }
  double& absorbed() { return this->Values[1]; }
  double& escaped() { return this->Values[2]; }
  double& trajectories() { return this->Values[3]; }
  double& starts(std::size_t surface) { return this->Values[fixed + each * surface]; }        ///< on its meshes
  double& lost(std::size_t surface) { return this->Values[fixed + each * surface + 1]; }      ///< of them, at once
  double& trapped(std::size_t surface) { return this->Values[fixed + each * surface + 2]; }   ///< of them, on itself
  double& lastSeen(std::size_t surface) { return this->Values[fixed + each * surface + 3]; }  ///< before an escape
  double& checked(std::size_t surface) { return this->Values[fixed + each * surface + 4]; }   ///< segments from there
  double& unseen(std::size_t surface) { return this->Values[fixed + each * surface + 5]; }    ///< of them, see below

  void add(const EnergySums& other);
  std::vector<double>& values() { return this->Values; }

private:
  static constexpr std::size_t fixed = 4, each = 6;
  std::vector<double> Values;
};

/// The sums of every replicate, and the checks on them.
class EnergyBalance
{
public:
  EnergyBalance(const Scene& scene, int replicates) : Scene_(scene), Sums(replicates, EnergySums(scene.surfaces())) {}

  EnergySums& of(int replicate) { return this->Sums[replicate]; }
  void exchange(const Ranks& ranks);
  void persist(Archive& archive);

  /// The line `energy`, and a line `warning` for each surface that seems to leak, or to emit to the wrong side:
  ///
  /// - leak: of the light, between 2e-5 (what rays may miss at shared edges) and 1e-3 (less than any opening that is
  ///   meant) leaves the scene; the surface is the one that most of it was last seen at.
  /// - wrong side: all of 32 or more starts on the surface leave the scene at once, or all of 1024 or more meet first
  ///   the surface itself, and there are others.
  /// - unseen: 8 or more of the vertices on a surface, and more than 1 in 200 of those checked, do not see the next hit
  /// of their own trajectory (see VisibilityCheck): local estimation loses their light.
  /// - imbalance: absorbed and escaped differ from emitted by more than 6 standard errors (false alarm below 1e-6).
  ///
  /// No lines where no trajectories were traced.
  std::vector<AuditLine> audit() const;

private:
  const Scene& Scene_;
  std::vector<EnergySums> Sums;
};
}  // namespace kalos

#endif
