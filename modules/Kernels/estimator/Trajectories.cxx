// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Trajectories.h"

#include "sampling/Warp.h"

namespace kalos
{
void VertexSet::add(const Scene& scene, const Vec3& p, const Vec3& n, const Bands& m)
{
  this->px.push_back(static_cast<float>(p.x));
  this->py.push_back(static_cast<float>(p.y));
  this->pz.push_back(static_cast<float>(p.z));
  this->nx.push_back(static_cast<float>(n.x));
  this->ny.push_back(static_cast<float>(n.y));
  this->nz.push_back(static_cast<float>(n.z));
  this->offset.push_back(static_cast<float>(length(scene.offset(p, n) - p)));
  for (std::size_t b = 0; b < this->flux.size(); ++b)
    this->flux[b].push_back(static_cast<float>(m[b]));
}

namespace
{
// Walks one trajectory. `onStart(sample)`, `onSegment(from, direction, point, weight, first)` and
// `onCollision(point, reflectedFlux)` see what happens.
template <class OnStart, class OnSegment, class OnCollision>
void walk(const Scene& scene, const Emission& emission, RandomStream random, OnStart onStart, OnSegment onSegment,
          OnCollision onCollision)
{
  const int bands = scene.bands();
  const EmissionSample start = emission.sample(random);
  onStart(start);
  Bands weight = start.weight;
  Vec3 direction = start.direction, from = start.position;
  SurfacePoint point = start.onSurface ? scene.trace(from, start.normal, direction) : scene.trace(from, direction);
  for (bool first = true;; first = false)
  {
    onSegment(from, direction, point, weight, first);
    if (!point.valid)
      return;

    // Reflect: score what leaves the vertex, then survive with the probability of the luminous share reflected.
    const Bands& reflectance = scene.material(point.triangle).reflectance;
    Bands reflectedFlux;
    for (int b = 0; b < bands; ++b)
      reflectedFlux[b] = reflectance[b] * weight[b];
    const double survival = photometric(reflectedFlux, bands) / photometric(weight, bands);
    if (!(survival > 0))
      return;
    onCollision(point, reflectedFlux);
    if (random.next() >= survival)
      return;
    for (int b = 0; b < bands; ++b)
      weight[b] = reflectedFlux[b] / survival;

    const double u1 = random.next(), u2 = random.next();
    direction = Frame(point.normal).toWorld(cosineHemisphere(u1, u2));
    from = point.position;
    point = scene.trace(from, point.normal, direction);
  }
}
}  // namespace

TrajectoryChunk traceTrajectories(const Scene& scene, const Emission& emission, std::uint64_t seed, int replicate,
                                  long long first, int count)
{
  TrajectoryChunk chunk{VertexSet(scene.bands()), VertexSet(scene.bands())};
  for (long long i = first; i < first + count; ++i)
  {
    walk(
        scene, emission, RandomStream(seed, replicate, Purpose::Trajectory, i),
        [&](const EmissionSample& start)
        {
          if (start.onSurface)
            chunk.emitted.add(scene, start.position, start.normal, start.weight);
        },
        [](auto&&...) {},
        [&](const SurfacePoint& point, const Bands& reflectedFlux)
        { chunk.reflected.add(scene, point.position, point.normal, reflectedFlux); });
  }
  return chunk;
}

void walkTrajectories(const Scene& scene, const Emission& emission, std::uint64_t seed, int replicate, long long first,
                      int count, const std::function<void(const Segment&)>& visit)
{
  for (long long i = first; i < first + count; ++i)
  {
    walk(
        scene, emission, RandomStream(seed, replicate, Purpose::Trajectory, i), [](auto&&...) {},
        [&](const Vec3& from, const Vec3& direction, const SurfacePoint& point, const Bands& weight, bool firstSegment)
        {
          Vec3 to = from + (4 * (scene.size() + length(from))) * direction;
          if (point.valid)
          {
            const double depth = length(scene.offset(point.position, point.normal) - point.position);
            to = point.position + (depth / std::max(0.01, -dot(direction, point.normal))) * direction;
          }
          visit({from, to, direction, weight, firstSegment});
        },
        [](auto&&...) {});
  }
}
}  // namespace kalos
