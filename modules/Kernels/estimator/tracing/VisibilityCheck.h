// SPDX-License-Identifier: BSD-3-Clause
// A check that every run makes: a vertex must see what its own trajectory went on to hit.
#ifndef kalos_estimator_tracing_VisibilityCheck_h
#define kalos_estimator_tracing_VisibilityCheck_h

#include "estimator/tracing/EnergyBalance.h"

namespace kalos
{
/// The trajectory has travelled from the vertex to the next surface point in double precision. Local estimation asks
/// again, with a shadow ray in single precision. Where the answers differ, the vertex does not deliver its light: the
/// sums count it, and EnergyBalance::audit() warns.
class VisibilityCheck
{
public:
  static constexpr long long every = 8;  ///< trajectories; a check costs a third of a segment

  VisibilityCheck(const Scene& scene, EnergySums& energy) : Scene_(scene), Energy(energy) {}

  /// The segment from a vertex at `from` on `surface` to a surface point.
  void add(const RayAnchor& from, std::size_t surface, const SurfacePoint& to);

  /// Counts what was added since.
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
