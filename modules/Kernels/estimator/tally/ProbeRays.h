// SPDX-License-Identifier: BSD-3-Clause
// Rays that explore the surroundings of a sensor before the estimate starts.
#ifndef kalos_estimator_tally_ProbeRays_h
#define kalos_estimator_tally_ProbeRays_h

#include "estimator/kernel/Sensor.h"
#include "sampling/Sobol.h"
#include "sampling/Warp.h"
#include "scene/RayBatch.h"

namespace kalos
{
/// Cosine-weighted direction number i about the normal of a frame, the same about every normal.
inline Vec3 probeDirection(const Frame& frame, int i)
{
  double u1, u2;
  sobolPoint(1, static_cast<std::uint32_t>(i), u1, u2);
  return frame.toWorld(cosineHemisphere(u1, u2));
}

/// Sends `count` of these rays and calls visit(G, y) for each that ends on a surface point y, with the kernel G (1/m2)
/// of that pair.
template <class Visit>
void sendProbes(const Scene& scene, const Sensor& sensor, int count, const Visit& visit)
{
  const Frame frame(sensor.normal);
  std::vector<PathRay> rays;
  rays.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    rays.push_back({sensor.anchor, probeDirection(frame, i), sensor.doublePrecision, {}});
  traceTogether(scene, rays);
  for (const PathRay& ray : rays)
  {
    if (!ray.end.valid)
      continue;
    const Vec3 d = ray.end.position - sensor.position;
    visit(dot(ray.direction, sensor.normal) * -dot(ray.direction, ray.end.normal) / (pi * dot(d, d)), ray.end.position);
  }
}
}  // namespace kalos

#endif
