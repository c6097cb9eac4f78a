// SPDX-License-Identifier: BSD-3-Clause
// Directions of gather rays of groups of receivers.
//
// The points are the first two dimensions of an Owen-scrambled Sobol' sequence. Each receiver of a group has a run of
// them, so that its own are stratified and those of the group as well. Each group has its own digital shift
// (in the distance from the normal) and its own rotation (about the normal). Points stay stratified and uniform, and
// neighbouring groups are decorrelated. Tracing needs no sine per ray.
#ifndef kalos_estimator_gathering_GatherPattern_h
#define kalos_estimator_gathering_GatherPattern_h

#include <vector>

#include "geometry/Vector.h"
#include "sampling/SampleStream.h"
#include "scene/RayScene.h"

namespace kalos
{
/// Where the rays of a receiver start, and its frame, turned by a key; single precision.
struct GatherStart
{
  float origin[3], u[3], v[3], n[3];

  GatherStart() = default;
  GatherStart(const Vec3& origin, const Vec3& normal, std::uint64_t key);
};

class GatherPattern
{
public:
  /// Rays [first, first + count) of a group, by the sequence that `key` selects; without Sobol, independent ones.
  GatherPattern(Sampling sampling, std::uint64_t key, long long first, int count);

  int size() const { return this->Count; }

  /// Where in that run ray i lies: rays are sorted by direction.
  int place(int i) const { return this->Place[i]; }

  /// Rays `begin` to begin + SegmentPacket::width, cosine-weighted about the normals; the last packet is filled up with
  /// rays that are not to be used. The receivers that begin at `starts` have `each` of the run, one after the other;
  /// the run may go on beyond the last. `key` is the group's own, as in the starts.
  void rays(const std::vector<GatherStart>& starts, int each, std::uint64_t key, int begin,
            SegmentPacket& packet) const;

private:
  int Count;
  std::vector<int> Place;             // in the run
  std::vector<std::uint32_t> Height;  // 32-bit fractions
  std::vector<float> Cosine, Sine;    // of the azimuth
};
}  // namespace kalos

#endif
