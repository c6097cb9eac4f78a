// SPDX-License-Identifier: BSD-3-Clause
// Which receivers gather together in final gathering, and how many rays each sends.
#ifndef kalos_estimator_gathering_GatherPlan_h
#define kalos_estimator_gathering_GatherPlan_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/gathering/GatherContext.h"
#include "estimator/gathering/ReceiverGroup.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
/// One replicate's round of gather rays.
struct GatherRound
{
  GatherPool pool;
  int replicate = 0;
  long long first = 0;     ///< number of rays that each receiver of a whole group has sent before
  int rays = 0;            ///< that it sends now
  float cellShare = 0;     ///< width of a cell over its viewing distance
  std::uint64_t seed = 0;  ///< of the random numbers of cells
};

class GatherPlan
{
public:
  /// `sensors` must outlive the plan.
  GatherPlan(const Scene& scene, const std::vector<Sensor>& sensors, const Settings& settings);

  /// Every receiver gathers by itself from now on: unshared rays take less time where luminous surfaces are all around
  /// (in a white furnace a thirtieth, to the same error).
  void leaveToPaths() { this->PathsOnly = true; }

  /// Whether receivers share the hits of their neighbours' rays. Not where luminous surfaces are all around, nor where
  /// most surfaces are glossy: their luminance depends on the viewer.
  bool sharesRays() const { return !this->PathsOnly && !this->OwnRays && this->MostlyDiffuse; }
  int groupSize() const { return this->sharesRays() ? ReceiverGroup::capacity : 1; }

  /// Trajectories of a replicate for each gather ray of a receiver in that replicate, in a whole group. With few
  /// receivers it pays to trace more trajectories, with many to trace more rays: the best ratio is proportional to the
  /// root of their number. For 64 x 64 points on a floor and on walls 128 and 512 took as long to the same error, for
  /// 48 along an edge 16 and 64.
  int trajectoriesPerRay() const;

  /// The round of a replicate after `raysDone` rays, for `active` receivers that have not converged.
  GatherRound round(const GatherPool& pool, int replicate, long long raysDone, std::size_t active) const;

  /// The receivers of a tile that have not converged, in groups; without those that cannot share hits.
  std::vector<ReceiverGroup> groups(std::size_t tile, const Tally& tally) const;

  /// The receivers of a tile that have not converged and cannot use the hits of their neighbours' rays: glossy ones,
  /// and those with another surface too near for single precision.
  std::vector<std::size_t> loners(std::size_t tile, const Tally& tally) const;

  /// Gather rays of each receiver of a group, given those of a receiver in a whole group: a smaller group sends as many
  /// in total.
  int raysOfEach(const ReceiverGroup& group, int rays) const;

  /// Gather rays of a group per trajectory, as they count in the MIS weights against vertices.
  double raysPerTrajectory(const ReceiverGroup& group, const GatherRound& round) const;

  AuditLine audit() const;

private:
  std::vector<std::size_t> activeIn(std::size_t tile, const Tally& tally, bool shares) const;

  const std::vector<Sensor>& Sensors;
  std::uint64_t Seed;
  bool OwnRays, MostlyDiffuse, PathsOnly = false;
  std::vector<std::size_t> Order;  // receivers, so that those beside each other follow each other
};
}  // namespace kalos

#endif
