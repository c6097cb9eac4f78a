// SPDX-License-Identifier: BSD-3-Clause
// Directions of gather rays that neighbouring receivers share.
//
// The points are the first two dimensions of an Owen-scrambled Sobol' sequence. A receiver takes them by a digital
// shift of its own (in the distance from the normal) and a turn of its own (about the normal): its points stay as
// stratified, each is uniform, and receivers beside each other are not shifted alike. No sine is left for a ray.
#ifndef kalos_estimator_GatherPattern_h
#define kalos_estimator_GatherPattern_h

#include <vector>

#include "geometry/Vector.h"
#include "sampling/SampleStream.h"
#include "scene/RayScene.h"

namespace kalos
{
class GatherPattern
{
public:
  /// Points [first, first + count) of the sequence that `key` selects; without Sobol, independent ones.
  GatherPattern(Sampling sampling, std::uint64_t key, long long first, int count);

  int size() const { return this->Count; }

  /// Rays `begin` to begin + SegmentPacket::width of a receiver, from `origin`, cosine-weighted about `normal`; the
  /// last packet is filled up with rays that are not to be used. `key` is the receiver's own.
  void rays(const Vec3& origin, const Vec3& normal, std::uint64_t key, int begin, SegmentPacket& packet) const;

private:
  int Count;
  std::vector<std::uint32_t> Height;  // 32-bit fractions
  std::vector<float> Cosine, Sine;    // of the azimuth
};
}  // namespace kalos

#endif
