// SPDX-License-Identifier: BSD-3-Clause
// What a user asks of a solve, and what comes back.
#ifndef kalos_estimator_Settings_h
#define kalos_estimator_Settings_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/Vector.h"
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
  double errorFloor = -1;      ///< lx, half-width that is small enough for any value; < 0: automatic, estimator/Goal.h
  double seconds = 0;          ///< goal: stop after this time; 0: no such goal
  std::uint64_t seed = 1;
  Sampling sampling = Sampling::Sobol;  ///< of trajectories, shadow and gather rays
  int threads = 0;                      ///< 0: all processors
  double delta = 0;                     ///< m, distance below which the sphere methods average; <= 0: automatic
  bool keepReplicates = false;          ///< fill Result::replicateIlluminance
  double epsilon = 0;  ///< m, radius of the averaging sphere or disc, half side of a point's cell; 0: automatic

  // Savings switched off, estimator/Savings.h; none moves a mean.
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

class Brdf;

/// Points where the illuminance is wanted, in world coordinates.
struct Receivers
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals;             ///< unit
  std::vector<std::vector<Vec3>> cells;  ///< corners of each receiver's own polygon; empty, or an empty cell: a point
  /// Empty (or not complete: not known), or m from where the kernel is singular: as far as a right-angled edge with the
  /// same kernel at that place would be, the distance over cot(alpha/2) of an edge of angle alpha. The audit holds it
  /// against what is gathered.
  std::vector<double> edgeDistances;
  std::vector<const Brdf*> brdfs;   ///< empty, or one each: not null asks for pi L reflected into `outgoing` instead
  std::vector<Vec3> outgoing;       ///< unit, with brdfs
  std::vector<char> followsMirror;  ///< 0: without the mirror part; with brdfs
};

struct AuditLine
{
  std::string subject, choice, reason;
};

struct Result
{
  int bands = 1;
  std::vector<double> illuminance;           ///< lx, photometric
  std::vector<double> standardError;         ///< lx, of the photometric illuminance
  std::vector<double> direct;                ///< lx, photometric, straight from the emitters
  std::vector<double> indirectError;         ///< lx, standard error of illuminance less direct
  std::vector<double> replicateIlluminance;  ///< lx, `replicates` estimates per receiver; see Settings::keepReplicates
  std::vector<double> illuminanceBands;      ///< lx, bands() values per receiver
  std::vector<double> kernelCorrection;      ///< lx, altered kernel less plain kernel on the same trajectories
  std::vector<double> largestScoreShare;     ///< largest single score over the sum of all, [0, 1]
  std::vector<char> trusted;                 ///< 1 where the standard error can be believed; rule in estimator/Trust.h
  std::vector<double> gatherRays;            ///< sent from each receiver by `compensated`; empty for other methods
  std::vector<char> goal;  ///< a GoalStatus each (estimator/Goal.h); empty without a goal for the error
  double errorFloor = 0;   ///< lx, by which that was judged
  long long trajectories = 0;
  long long rays = 0;  ///< traced by the solve; those of other solves of the process at the same time are in it
  int replicates = 0;
  bool aborted = false;
  bool alteredKernel = false;  ///< the method alters the kernel, kernelCorrection means something
  double seconds = 0, cpuSeconds = 0;
  std::vector<AuditLine> audit;
};

/// Called now and then on the thread that called solve(), with a fraction in [0,1]; returns false to abort.
/// While it runs, the solve rests: a callback that waits is a pause.
using Progress = std::function<bool(double)>;

/// Called after each round, on the thread that called solve(), with the result so far.
using Snapshot = std::function<void(const Result&)>;
}  // namespace kalos

#endif
