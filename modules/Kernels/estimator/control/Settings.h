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

  // Disabled techniques (estimator/control/Techniques.h); none adds bias.
  bool gatherEverywhere = false;   ///< gather rays even where nothing is near
  bool shadowEveryPair = false;    ///< a shadow ray for every pair that scores
  bool shadowConvexRooms = false;  ///< shadow rays where nothing can occlude
  bool alwaysVertices = false;     ///< use vertices even where paths from the receivers are better
  bool ownRays = false;            ///< a gather ray lights only the receiver that sent it, not its neighbours
  bool evenEffort = false;         ///< all receivers continue until the last has reached the goal
  bool vertexHighlights = false;   ///< highlights of luminaires by vertices and gather rays alone
  bool sampleDirect = false;       ///< sample area emitters instead of using their closed form

  const Ranks* ranks = nullptr;  ///< processes that share the solve; null: only this one

  CheckpointStore* checkpoint = nullptr;  ///< where the solve is saved and resumed; null: nowhere

  Walks walks() const { return {this->seed, this->sampling}; }
};

/// Trajectories of a solve without goal and limit. Automatic lengths assume this number where there is no limit.
constexpr long long defaultTrajectories = 10000;

}  // namespace kalos

#endif
