// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/PilotPaths.h"

#include <algorithm>

#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr double leastSurvival = 0.5;  // so that paths from receivers pass dark rooms, too

// Goes on from a start, until roulette or the open ends the path.
void follow(const Scene& scene, const RayAnchor& start, Vec3 direction, double weight, SampleStream& random,
            PilotPoint& at, const VisitPilotPoint& visit)
{
  at.first = true;
  at.point = scene.trace(start, direction);
  while (at.point.valid)
  {
    const Brdf& brdf = scene.brdf(at.point.triangle);
    const double mirror = brdf.material().mirror;
    const double albedo = brdf.albedo(-dot(at.point.normal, direction), uniformBands(1));
    at.flux = weight * albedo;
    visit(at);
    const double survival = at.fromReceivers ? std::max(leastSurvival, albedo + mirror) : albedo + mirror;
    const double u = random.next(), u1 = random.next(), u2 = random.next();
    if (u >= survival)
      return;
    at.before = at.point;
    at.first = false;
    direction = u * (albedo + mirror) < mirror * survival ? reflected(-direction, at.point.normal)
                                                          : Frame(at.point.normal).toWorld(cosineHemisphere(u1, u2));
    at.point = scene.trace(scene.anchor(at.before), direction);
  }
}
}  // namespace

void visitLight(const Scene& scene, const Emission& emission, const Walks& walks, int replicate, long long first,
                int count, const VisitPilotPoint& visit)
{
  for (long long i = first; i < first + count; ++i)
  {
    SampleStream random = walks.stream(replicate, Purpose::Trajectory, i);
    const EmissionSample start = emission.sample(random);
    PilotPoint at;
    follow(scene, start.anchor, start.direction, photometric(start.weight, scene.bands()), random, at, visit);
  }
}

void visitImportance(const Scene& scene, const std::vector<Sensor>& sensors, const Walks& walks, int replicate,
                     long long first, int count, const VisitPilotPoint& visit)
{
  for (long long i = first; i < first + count; ++i)
  {
    SampleStream random = walks.stream(replicate, Purpose::Gather, i);
    PilotPoint at;
    at.sensor = static_cast<std::size_t>(i) % sensors.size();
    const Sensor& sensor = sensors[at.sensor];
    const double u1 = random.next(), u2 = random.next();
    at.fromReceivers = true;
    follow(scene, sensor.anchor, Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2)), 1, random, at, visit);
  }
}
}  // namespace kalos
