// SPDX-License-Identifier: BSD-3-Clause
// Gather rays of receivers, some hundreds under way at a time (estimator/gathering/WavefrontGather.h), and what they
// add to a tally.
#ifndef kalos_estimator_gathering_ReceiverRays_h
#define kalos_estimator_gathering_ReceiverRays_h

#include "estimator/gathering/WavefrontGather.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
/// Of one replicate and round. What is added last is in the tally after finish().
class ReceiverRays
{
public:
  ReceiverRays(const GatherContext& gathering, const GatherPool& pool, int replicate, Tally& tally);

  /// Sends one of `rays` gather rays of the receiver.
  void gather(std::size_t receiver, int rays, const Sensor& sensor, const WavefrontGather::Start& start,
              const SampleStream& random);

  /// The same along a ray that is given, which met the surface point y.
  void follow(std::size_t receiver, int rays, const Sensor& sensor, const Vec3& direction, const SurfacePoint& y,
              const WavefrontGather::Start& start, const SampleStream& random);

  void finish();

private:
  struct Owner
  {
    std::size_t receiver;
    double weight;
  };
  void add(std::size_t receiver, int rays);

  const GatherPool& Pool;
  int Replicate;
  Tally& Scores;
  WavefrontGather Wave;
  std::vector<Owner> Owners;  // of the rays of the wave
};
}  // namespace kalos

#endif
