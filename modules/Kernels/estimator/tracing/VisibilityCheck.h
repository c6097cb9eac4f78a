// SPDX-License-Identifier: BSD-3-Clause
// A check in every run: a vertex must see the next hit of its own trajectory.
#ifndef kalos_estimator_tracing_VisibilityCheck_h
#define kalos_estimator_tracing_VisibilityCheck_h

#include "estimator/tracing/EnergyBalance.h"

namespace kalos
{
/// The trajectory has travelled from the vertex to the next surface point in double precision. Local estimation tests
/// the same segment with a shadow ray in single precision. Where the two disagree, the light of the vertex is lost: the
/// sums count it, and EnergyBalance::audit() warns.
class VisibilityCheck
{
public:
  static constexpr long long every = 8;  ///< trajectories; a check costs a third of a segment

  VisibilityCheck(const Scene& scene, EnergySums& energy) : Scene_(scene), Energy(energy) {}

  /// The segment from a vertex at `from` on `surface` to a surface point.
  void add(const RayAnchor& from, std::size_t surface, const SurfacePoint& to);

  /// Traces the segments added since the last call, and counts them.
  void finish();

private:
  const Scene& Scene_;
  EnergySums& Energy;
  SegmentPacket Packet;
  std::size_t Surface[SegmentPacket::width];
  int Count = 0;
};
}  // namespace kalos

#endif
