// SPDX-License-Identifier: BSD-3-Clause
// Also known as: bias compensation of virtual point lights (Kollig and Keller 2004).
//
// All light at sensors except that of luminaires (direct or by mirror images), by vertices and gather rays: unbiased
// and bounded. Formula and sources: estimator/methods/CompensatedEstimation.h.
#ifndef kalos_estimator_methods_BiasCompensation_h
#define kalos_estimator_methods_BiasCompensation_h

#include <functional>

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/control/Workers.h"
#include "estimator/gathering/ReceiverRays.h"

namespace kalos
{
/// The trajectories of one round, of every replicate, annotated by the pilot.
struct Round
{
  long long first;
  int count;
  int rays;  ///< of each sensor that gathers, in each replicate
  std::vector<LightVertices> pools;
};

class BiasCompensation
{
public:
  /// `receivers`: number of receivers in the whole solve that share each trajectory.
  BiasCompensation(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows,
                   std::size_t receivers);

  const GatherContext& gathering() const { return this->Rays; }

  /// Turns vertices off: gather rays find all light (GatherContext::usePathsOnly). Call before prepare().
  void usePathsOnly()
  {
    this->Rays.usePathsOnly();
    this->Clearance = std::numeric_limits<double>::infinity();
  }

  /// Decides how much each sensor gathers. Returns false when aborted.
  bool prepare(const std::vector<Sensor>& sensors, Workers& workers);

  /// Traces trajectories [first, first + count); no pools when aborted.
  Round trace(long long first, int count, int replicates, Workers& workers) const;

  /// Adds a round's scores at sensors [begin, end) that have not converged. Includes emitting meshes unless
  /// exactMeshes(r) says that their light is known exactly.
  void score(const std::vector<Sensor>& sensors, std::size_t begin, std::size_t end, int replicate, const Round& round,
             const std::function<bool(std::size_t)>& exactMeshes, Tally& tally) const;

  /// Call after a round has been scored at all sensors that have not converged.
  void finish(const Round& round, const Tally& tally);

  /// Saves or restores the state carried between rounds.
  void persist(Archive& archive)
  {
    archive.array(this->RaysDone);
    archive.value(this->TrajectoriesDone);
  }

  /// Gather rays that each sensor has sent, of `replicates` together.
  std::vector<double> raysSent(int replicates) const;

  /// Where gather rays were sent and how many. `edgeDistances` as in Receivers.
  AuditLine audit(int replicates, const std::vector<double>& edgeDistances) const;

private:
  double rayShare() const;  // gather rays per trajectory, of a sensor that gathers
  bool needsRays(const Sensor& sensor) const;
  int rays(std::size_t r, const Round& round) const { return this->Gathers[r] ? round.rays : 0; }
  double balance(std::size_t r, const Round& round) const;  // gather rays per trajectory, as they count for G*
  void sendRays(const Sensor& sensor, std::size_t r, int replicate, const Round& round, bool exactMeshes,
                ReceiverRays& gathered) const;

  const Scene& Scene_;
  const Emission& Source;
  Settings Settings_;
  std::size_t ReceiverCount;  // receivers of the whole solve; none where an image sees no surface
  GatherContext Rays;
  double Clearance;                 // m; sensors that are clear at this distance need no gather rays
  std::vector<char> Gathers;        // per sensor
  std::vector<long long> RaysDone;  // of a replicate in earlier rounds, per sensor
  long long TrajectoriesDone = 0;   // of a replicate
};
}  // namespace kalos

#endif
