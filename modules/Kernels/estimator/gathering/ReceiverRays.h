// SPDX-License-Identifier: BSD-3-Clause
// Sends gather rays of receivers in batches of some hundreds (estimator/gathering/WavefrontGather.h) and adds their
// light to a tally.
#ifndef kalos_estimator_gathering_ReceiverRays_h
#define kalos_estimator_gathering_ReceiverRays_h

#include "estimator/gathering/WavefrontGather.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
/// Of one replicate and round. Call finish() to add the last batch to the tally.
class ReceiverRays
{
public:
  ReceiverRays(const GatherContext& gathering, const GatherPool& pool, int replicate, Tally& tally);

  /// Sends one of `rays` gather rays of the receiver.
  void gather(std::size_t receiver, int rays, const Sensor& sensor, const WavefrontGather::Start& start,
              const SampleStream& random);

  /// The same for a given ray, which hit the surface point y.
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
