// SPDX-License-Identifier: BSD-3-Clause
// Rays that look at what surrounds a sensor before anything is estimated.
#ifndef kalos_estimator_ProbeRays_h
#define kalos_estimator_ProbeRays_h

#include "estimator/Sensor.h"
#include "sampling/Sobol.h"
#include "sampling/Warp.h"

namespace kalos
{
/// Cosine-weighted direction number i about the normal of a frame, the same about every normal.
inline Vec3 probeDirection(const Frame& frame, int i)
{
  double u1, u2;
  sobolPoint(1, static_cast<std::uint32_t>(i), u1, u2);
  return frame.toWorld(cosineHemisphere(u1, u2));
}

/// Sends `count` of these rays and calls visit(G, y) for each that ends on a
/// surface point y, with the kernel G (1/m2) of that pair.
template <class Visit>
void sendProbes(const Scene& scene, const Sensor& sensor, int count, const Visit& visit)
{
  const Frame frame(sensor.normal);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 direction = probeDirection(frame, i);
    const SurfacePoint y = scene.trace(sensor.position, sensor.normal, direction);
    if (!y.valid)
      continue;
    const Vec3 d = y.position - sensor.position;
    visit(dot(direction, sensor.normal) * -dot(direction, y.normal) / (pi * dot(d, d)), y.position);
  }
}
}  // namespace kalos

#endif
