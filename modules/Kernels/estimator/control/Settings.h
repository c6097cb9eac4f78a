// SPDX-License-Identifier: BSD-3-Clause
// What a user asks of a solve.
#ifndef kalos_estimator_control_Settings_h
#define kalos_estimator_control_Settings_h

#include <cstdint>

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
  Direct
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
  Sampling sampling = Sampling::Sobol;  ///< of trajectories, shadow and gather rays
  int threads = 0;                      ///< 0: all processors
  double delta = 0;                     ///< m, distance below which the sphere methods average; <= 0: automatic
  bool keepReplicates = false;          ///< fill Result::replicateIlluminance
  double epsilon = 0;  ///< m, radius of the averaging sphere or disc, half side of a point's cell; 0: automatic

  // Savings switched off, estimator/control/Techniques.h; none moves a mean.
  bool gatherEverywhere = false;   ///< gather rays where nothing is near, too
  bool shadowEveryPair = false;    ///< a shadow ray for every pair that scores
  bool shadowConvexRooms = false;  ///< shadow rays where nothing can occlude
  bool alwaysVertices = false;     ///< vertices score where paths from the receivers alone are better, too
  bool ownRays = false;            ///< gather rays light the receiver that sent them alone, not its neighbours
  bool evenEffort = false;         ///< all receivers go on until the last has reached the goal
  bool sampleDirect = false;       ///< area emitters are sampled, not known in closed form

  const Ranks* ranks = nullptr;  ///< processes that share the solve; null: this one alone

  CheckpointStore* checkpoint = nullptr;  ///< where the solve is kept and goes on from; null: nowhere

  Walks walks() const { return {this->seed, this->sampling}; }
};

/// Trajectories of a solve without a goal and a limit, and those that automatic lengths are made for where there is no
/// limit.
constexpr long long defaultTrajectories = 10000;

}  // namespace kalos

#endif
