// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/Trajectories.h"

#include "estimator/tracing/VisibilityCheck.h"

namespace kalos
{
void LightVertices::append(const LightVertices& other)
{
  this->reflected.append(other.reflected);
  this->glossy.append(other.glossy);
  this->emitted.append(other.emitted);
  this->energy.add(other.energy);
}

namespace
{
// Counts the first hits of light from an emitting mesh.
void noteStart(const Scene& scene, std::size_t surface, const SurfacePoint& met, EnergySums& energy)
{
  energy.starts(surface) += 1;
  if (!met.valid)
    energy.lost(surface) += 1;
  else if (scene.surface(met.triangle) == surface)
    energy.trapped(surface) += 1;
}

// Walks one trajectory. `onStart(sample)`, `onSegment(from, direction, point, weight, first, byMirrors)` and
// `onCollision(point, towardsLight, weight, caustic, straight)` are called at each event. Adds the energy balance to
// `energy`.
template <class OnStart, class OnSegment, class OnCollision>
void walk(const Scene& scene, const Emission& emission, SampleStream random, EnergySums& energy, OnStart onStart,
          OnSegment onSegment, OnCollision onCollision)
{
  const EmissionSample start = emission.sample(random);
  onStart(start);
  Bands weight = start.weight;
  double luminous = photometric(weight, scene.bands());
  energy.emitted() += luminous;
  energy.trajectories() += 1;
  Vec3 direction = start.direction;
  bool fromPoint = start.fromPoint;
  RayAnchor from = start.anchor;
  SurfacePoint point = scene.trace(from, direction);
  if (start.onSurface)
    noteStart(scene, scene.surface(start.triangle), point, energy);
  std::size_t last = start.onSurface ? scene.surface(start.triangle) : scene.surfaces();
  for (bool first = true;; first = false)
  {
    onSegment(from, direction, point, weight, first, fromPoint && !first);
    if (!point.valid)
    {
      energy.escaped() += luminous;
      if (last < scene.surfaces())
        energy.lastSeen(last) += 1;
      return;
    }
    onCollision(point, -direction, weight, fromPoint && !first, first && !start.onSurface);

    // Russian roulette: absorbed with the probability of the luminous absorptance, else reflected.
    const Brdf& brdf = scene.brdf(point.triangle);
    energy.absorbed() += luminous * (1 - brdf.material().mirror - brdf.albedo(-dot(point.normal, direction), weight));
    last = scene.surface(point.triangle);
    const double u0 = random.next(), u1 = random.next(), u2 = random.next();
    const BrdfSample next = brdf.sample(point.normal, -direction, weight, u0, u1, u2);
    if (!next.alive)
      return;
    fromPoint = fromPoint && next.mirror;
    for (int b = 0; b < scene.bands(); ++b)
      weight[b] *= next.weight[b];
    luminous = photometric(weight, scene.bands());
    direction = next.direction;
    from = scene.anchor(point);
    point = scene.trace(from, direction);
  }
}
}  // namespace

LightVertices traceTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                                long long first, int count)
{
  LightVertices pool(scene.bands(), scene.surfaces());
  std::size_t emitter = 0;  // of the trajectory
  auto keep = [&](const SurfacePoint& point, const Vec3& towardsLight, const Bands& weight, bool caustic,
                  bool straight) {
    const Material& material = scene.material(point.triangle);
    const double inverse = caustic ? 0 : -1;
    if (material.specular > 0)
      return pool.glossy.addGlossy(scene, point, towardsLight, weight, inverse);
    Bands reflected{};
    for (int b = 0; b < scene.bands(); ++b)
      reflected[b] = material.reflectance[b] * weight[b];
    if (photometric(reflected, scene.bands()) > 0)  // a mirror's vertex scores nothing
      pool.reflected.add(scene.anchor(point), reflected, inverse,
                         straight ? emission.firstHitDensity(emitter, point.position, point.normal) : 0);
  };
  VisibilityCheck check(scene, pool.energy);
  for (long long i = first; i < first + count; ++i)
  {
    std::size_t surface = scene.surfaces();  // where the vertex lies; from a luminaire: none
    walk(
        scene, emission, walks.stream(replicate, Purpose::Trajectory, i), pool.energy,
        [&](const EmissionSample& start) {
          emitter = start.emitter;
          if (!start.onSurface)
            return;
          pool.emitted.add(start.anchor, start.weight, 1 / start.density);
          surface = scene.surface(start.triangle);
        },
        [&](const RayAnchor& from, const Vec3&, const SurfacePoint& point, const Bands&, bool, bool) {
          if (!point.valid)
            return;
          if (surface < scene.surfaces() && i % VisibilityCheck::every == 0)
            check.add(from, surface, point);
          surface = scene.surface(point.triangle);
        },
        keep);
  }
  check.finish();
  return pool;
}

EnergySums walkTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                            long long first, int count, const std::function<void(const Segment&)>& visit)
{
  EnergySums energy(scene.surfaces());
  bool fromMesh = false;
  for (long long i = first; i < first + count; ++i)
  {
    walk(
        scene, emission, walks.stream(replicate, Purpose::Trajectory, i), energy,
        [&](const EmissionSample& start) { fromMesh = start.onSurface; },
        [&](const RayAnchor& start, const Vec3& direction, const SurfacePoint& point, const Bands& weight,
            bool firstSegment, bool byMirrors) {
          const Vec3 from = start.lifted();
          Vec3 to = from + (4 * (scene.size() + length(from))) * direction;
          if (point.valid)
          {
            const double depth = scene.anchor(point).lift();
            to = point.position + (depth / std::max(0.01, -dot(direction, point.normal))) * direction;
          }
          visit({from, to, direction, weight, firstSegment, fromMesh, byMirrors, point});
        },
        [](auto&&...) {});
  }
  return energy;
}
}  // namespace kalos
