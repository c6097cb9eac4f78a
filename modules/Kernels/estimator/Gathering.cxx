// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Gathering.h"

#include "sampling/Warp.h"

namespace kalos
{
CollisionDensity measureDensity(const Scene& scene, const Emission& emission, std::uint64_t seed)
{
  constexpr int pilot = 256;
  constexpr int pilotReplicate = 1 << 20;  // no estimate uses it
  CollisionDensity density;
  density.surfaceArea = scene.surfaceArea();
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
      density.emittingArea += scene.area(t);
  if (!(emission.totalFlux() > 0))
    return density;
  const VertexPool pool = traceTrajectories(scene, emission, seed, pilotReplicate, 0, pilot);
  const auto collisions = static_cast<double>(pool.reflected.size() + pool.glossy.size());
  if (density.surfaceArea > 0)
    density.reflected = std::max(1.0, collisions) / pilot / density.surfaceArea;
  if (density.emittingArea > 0)
    density.emitted = std::max(1.0, static_cast<double>(pool.emitted.size())) / pilot / density.emittingArea;
  return density;
}

Gathering::Gathering(const Scene& scene, const CollisionDensity& density, bool shadows)
    : Lit(scene), Density(density), Shadows(shadows), Luminaires(scene, false, shadows)
{
}

PairLimits Gathering::limits(double trajectories, double rays) const
{
  return {this->Density.reflected * trajectories / rays, this->Density.emitted * trajectories / rays};
}

PairLimits Gathering::blockLimits(int trajectories) const
{
  // A block of each set against one gather ray.
  return {std::min(this->Density.reflected * trajectories, blockSize / this->Density.surfaceArea),
          std::min(this->Density.emitted * trajectories,
                   this->Density.emittingArea > 0 ? blockSize / this->Density.emittingArea : 0)};
}

bool Gathering::draw(const Sensor& sensor, double u1, double u2, RandomStream& random, Ray& ray,
                     Bands& throughput) const
{
  if (!sensor.brdf)
  {
    ray.direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    ray.density = dot(ray.direction, sensor.normal) / pi;
    ray.mirror = false;
    return ray.density > 0;
  }
  const Bands white = uniformBands(1);
  const BrdfSample sample = sensor.brdf->sample(sensor.normal, sensor.outgoing, white, random.next(), u1, u2);
  if (!sample.alive || (sample.mirror && !sensor.followsMirror))
    return false;
  ray.direction = sample.direction;
  ray.density = sample.density;
  ray.mirror = sample.mirror;
  double share = 1;  // vertices do not score on a mirror
  if (!sample.mirror)
  {
    const Bands f = sensor.brdf->timesPi(sensor.normal, ray.direction, sensor.outgoing);
    share = gatheredShare(sensor.ratio * lobeRatio(*sensor.brdf, sensor.normal, ray.direction, f, this->Lit.bands()));
  }
  for (int b = 0; b < this->Lit.bands(); ++b)
    throughput[b] *= share * sample.weight[b];
  return true;
}

Bands Gathering::gather(const Sensor& sensor, const GatherPool& pool, const Start& start, RandomStream& random,
                        Bands& emission) const
{
  const int bands = this->Lit.bands();
  const PairLimits later = this->blockLimits(pool.trajectories);
  PairLimits limits = start.limits;
  bool seesEmission = start.seesEmission;
  double u1 = start.u1, u2 = start.u2;
  Sensor at = sensor;
  Bands sum{}, throughput = uniformBands(1);
  for (bool first = true;; first = false)
  {
    // Find what the sensor sees in a direction of its response.
    Ray ray;
    if (!this->draw(at, u1, u2, random, ray, throughput))
      return sum;
    const SurfacePoint y = this->Lit.trace(at.position, at.normal, ray.direction);
    if (ray.mirror)
      this->Luminaires.addSeen(at.rayOrigin, ray.direction, y, throughput, sum);
    if (!y.valid)
      return sum;
    const Vec3 d = y.position - at.position;
    const double kernel = ray.density * -dot(ray.direction, y.normal) / dot(d, d);  // G, for a Lambertian sensor
    const double ratio = ray.mirror ? std::numeric_limits<double>::infinity() : kernel / limits.reflected;

    // Add what it emits, less the share that starts on meshes score.
    const Material& material = this->Lit.material(y.triangle);
    if (y.front && (ray.mirror || seesEmission))
    {
      const double share = ray.mirror ? 1 : gatheredShare(kernel / limits.emitted);
      for (int b = 0; b < bands; ++b)
      {
        const double e = throughput[b] * share * material.exitance[b];
        sum[b] += e;
        if (first && !ray.mirror)
          emission[b] += e;
      }
    }

    // Become the sensor there: its illuminance, or its response towards here.
    Sensor next(this->Lit, y.position, y.normal);
    const Brdf& brdf = this->Lit.brdf(y.triangle);
    if (brdf.isLambertian())
      for (int b = 0; b < bands; ++b)
        throughput[b] *= gatheredShare(ratio) * material.reflectance[b];
    else
    {
      next.brdf = &brdf;
      next.outgoing = -ray.direction;
      next.ratio = ratio;
    }
    const double luminous = photometric(throughput, bands);
    if (!(luminous > 0))
      return sum;
    auto survives = [&] {
      if (luminous >= 1)
        return true;
      if (random.next() >= luminous)
        return false;
      for (int b = 0; b < bands; ++b)
        throughput[b] /= luminous;
      return true;
    };
    if (!first && !survives())
      return sum;
    this->addVertexLight(next, pool, random, throughput, sum);
    if (first && !survives())
      return sum;

    at = next;
    limits = later;
    seesEmission = true;
    u1 = random.next();
    u2 = random.next();
  }
}

void Gathering::addVertexLight(const Sensor& sensor, const GatherPool& pool, RandomStream& random,
                               const Bands& throughput, Bands& sum) const
{
  thread_local DirectLight::View scratch;
  const Bands direct = this->Luminaires.sample(sensor, random, scratch);
  const PairLimits limits = this->blockLimits(pool.trajectories);
  Bands vertices{};
  this->scoreBlock(sensor, pool.vertices->reflected, limits.reflected, random, vertices);
  this->scoreBlock(sensor, pool.vertices->glossy, limits.reflected, random, vertices);
  this->scoreBlock(sensor, pool.vertices->emitted, limits.emitted, random, vertices);
  for (int b = 0; b < this->Lit.bands(); ++b)
    sum[b] += throughput[b] * (direct[b] + vertices[b] / pool.trajectories);
}

void Gathering::scoreBlock(const Sensor& sensor, const VertexSet& set, double limit, RandomStream& random,
                           Bands& sum) const
{
  if (set.size() == 0)
    return;
  // A run of vertices from a random start, around the end: each is in it with the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size);
  Bands scores{};
  PairBlock block;
  auto score = [&](std::size_t from, std::size_t count) {
    formPairs(set, from, static_cast<int>(count), sensor, 1 / limit, block);
    if (this->Shadows)
      addPickedScores(this->Lit.rays(), set, sensor, block, 1, random.next(), scores.data());
    else
      addScores(set, block, scores.data());
  };
  score(begin, straight);
  if (straight < size)
    score(0, size - straight);
  for (int b = 0; b < this->Lit.bands(); ++b)
    sum[b] += weight * scores[b];
}
}  // namespace kalos
