// SPDX-License-Identifier: BSD-3-Clause
// What a user asks of a solve.
#ifndef kalos_estimator_control_Settings_h
#define kalos_estimator_control_Settings_h

#include <cstdint>

#include "estimator/control/MethodOptions.h"
#include "estimator/control/Techniques.h"
#include "sampling/SampleStream.h"

namespace kalos
{
enum class Method
{
  Local,
  SpherePublished,
  SphereExact,
  Disc,
  Clamped,
  Compensated,
  Gathered,
  Direct,
  Paths,
  PhotonMap
};

class Ranks;
class CheckpointStore;

struct Settings
{
  Method method = Method::Compensated;
  long long trajectories = 0;  ///< upper limit over all replicates; 0: no limit with a goal below, else 10 000
  double relativeError = 0;    ///< goal: 95 % half-width over value at every receiver; 0: no such goal
  double errorFloor =
      -1;              ///< lx, half-width that is small enough for any value; < 0: automatic, estimator/tally/Goal.h
  double seconds = 0;  ///< goal: stop after this time; 0: no such goal
  std::uint64_t seed = 1;
  TechniqueSet disabled;        ///< techniques to do without; none adds bias
  int threads = 0;              ///< 0: all processors
  double delta = 0;             ///< m, distance below which the sphere methods average; <= 0: automatic
  bool keepReplicates = false;  ///< fill Result::replicateIlluminance
  double epsilon = 0;  ///< m, radius of the averaging sphere or disc, half side of a point's cell; 0: automatic

  MethodOptions own;  ///< of single methods

  const Ranks* ranks = nullptr;  ///< processes that share the solve; null: only this one

  CheckpointStore* checkpoint = nullptr;  ///< where the solve is saved and resumed; null: nowhere

  bool uses(Technique t) const { return !this->disabled.contains(t); }

  /// The random numbers of trajectories, shadow and gather rays.
  Walks walks() const
  {
    return {this->seed, this->uses(Technique::Stratified) ? Sampling::Sobol : Sampling::Independent};
  }
};

/// Trajectories of a solve without goal and limit. Automatic lengths assume this number where there is no limit.
constexpr long long defaultTrajectories = 10000;

}  // namespace kalos

#endif
