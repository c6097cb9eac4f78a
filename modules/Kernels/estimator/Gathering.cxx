// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Gathering.h"

#include "estimator/VertexRound.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
// The chance that a path goes on when it is alone, over its throughput: in a white furnace 10 took three times the time
// of 20 to the same error, in rooms that are luminous in part 20 a quarter more than 5.
constexpr double keptAlone = 20;

constexpr int keptForBalance = 16;  // one of so many trajectories is traced when no path meets their vertices
}  // namespace

Gathering::Gathering(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows)
    : Lit(scene),
      Density(scene, emission, settings.walks()),
      Shadows(shadows),
      Picks(settings.shadowEveryPair ? 0 : 1),
      Luminaires(scene, false, shadows),
      Mirrored(scene)
{
}

std::vector<VertexPool> Gathering::trace(const Emission& emission, const Walks& walks, int replicates, long long first,
                                         int count, Workers& workers) const
{
  if (this->Alone)
  {
    const long long begin = (first + keptForBalance - 1) / keptForBalance;
    const long long end = (first + count + keptForBalance - 1) / keptForBalance;
    return traceRound(this->Lit, emission, walks, replicates, begin, static_cast<int>(end - begin), workers);
  }
  std::vector<VertexPool> pools = traceRound(this->Lit, emission, walks, replicates, first, count, workers);
  if (!workers.forEach(pools.size(), [&](std::size_t p) { this->Density.annotate(pools[p]); }))
    pools.clear();
  return pools;
}

double Gathering::blockShare(int trajectories, int blockSize) const
{
  if (this->Alone)
    return std::numeric_limits<double>::infinity();
  // One gather ray against the trajectories that a block stands for.
  const double vertices = std::max(this->Density.collisions(), this->Density.starts()) * trajectories;
  return 1 / (trajectories * std::min(1.0, blockSize / vertices));
}

bool Gathering::draw(const Sensor& sensor, SampleStream& random, Ray& ray, Bands& throughput) const
{
  const double u1 = random.next(), u2 = random.next();
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
  if (!sample.mirror && !std::isinf(sensor.ratio))
  {
    const Bands f = sensor.brdf->timesPi(sensor.normal, ray.direction, sensor.outgoing);
    share = gatheredShare(sensor.ratio * lobeRatio(*sensor.brdf, sensor.normal, ray.direction, f, this->Lit.bands()));
  }
  for (int b = 0; b < this->Lit.bands(); ++b)
    throughput[b] *= share * sample.weight[b];
  return true;
}

Bands Gathering::gather(const Sensor& sensor, const GatherPool& pool, const Start& start, SampleStream& random,
                        Bands& emission) const
{
  Chain chain{sensor, uniformBands(1), start.share, start.seesEmission};
  Bands sum{};
  this->finish(chain, pool, random, sum, emission);
  return sum;
}

Bands Gathering::follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y, const GatherPool& pool,
                        const Start& start, SampleStream& random, Bands& emission) const
{
  Chain chain{sensor, uniformBands(1), start.share, start.seesEmission};
  Bands sum{};
  const Ray ray{direction, dot(direction, sensor.normal) / pi, false};
  if (this->advance(chain, ray, y, pool, random, sum, emission))
    this->finish(chain, pool, random, sum, emission);
  return sum;
}

Bands Gathering::luminaireLight(const Sensor& sensor, SampleStream& random) const
{
  Bands light = this->Luminaires.sample(sensor, random);
  this->addMirrored(sensor, light);
  return light;
}

void Gathering::luminaireLight(const Sensor* sensors, int count, SampleStream& random, Bands* light) const
{
  this->Luminaires.sample(sensors, count, random, light);
  for (int i = 0; i < count; ++i)
    this->addMirrored(sensors[i], light[i]);
}

void Gathering::addMirrored(const Sensor& sensor, Bands& light) const
{
  if (!this->Mirrored.any())
    return;
  const Bands images = this->Mirrored.illuminance(sensor);
  for (int b = 0; b < this->Lit.bands(); ++b)
    light[b] += images[b];
}

Bands Gathering::indirectLight(const Sensor& sensor, const GatherPool& pool, SampleStream& random) const
{
  Chain chain{sensor, uniformBands(1), this->blockShare(pool.trajectories, cellBlock), true, false};
  Bands sum{}, unused{};
  this->addVertexLight(sensor, pool, cellBlock, random, chain.throughput, sum);
  this->finish(chain, pool, random, sum, unused);
  return sum;
}

void Gathering::finish(Chain& chain, const GatherPool& pool, SampleStream& random, Bands& sum, Bands& emission) const
{
  // Find what the sensor sees in a direction of its response.
  Ray ray;
  while (this->draw(chain.at, random, ray, chain.throughput) &&
         this->advance(chain, ray, this->Lit.trace(chain.at.position, chain.at.normal, ray.direction), pool, random,
                       sum, emission))
    continue;
}

bool Gathering::advance(Chain& chain, const Ray& ray, const SurfacePoint& y, const GatherPool& pool,
                        SampleStream& random, Bands& sum, Bands& emission) const
{
  const int bands = this->Lit.bands();
  const double later = this->blockShare(pool.trajectories, rayBlock), share = chain.share;
  const Sensor& at = chain.at;
  Bands& throughput = chain.throughput;
  const bool first = chain.first;
  if (ray.mirror)
    this->Luminaires.addSeen(at.anchor.lifted, ray.direction, y, throughput, sum);
  if (!y.valid)
    return false;
  const Vec3 d = y.position - at.position;
  const bool whole = ray.mirror || std::isinf(share);                             // no vertex scores there
  const double kernel = ray.density * -dot(ray.direction, y.normal) / dot(d, d);  // G, for a Lambertian sensor
  const double ratio =
      whole ? std::numeric_limits<double>::infinity() : kernel * share / this->Density.density(y.position);

  // Add what it emits, less the share that starts on meshes score.
  const Material& material = this->Lit.material(y.triangle);
  if (y.front && (ray.mirror || chain.seesEmission) && photometric(material.exitance, bands) > 0)
  {
    const double gathered = whole ? 1 : gatheredShare(kernel * share / this->Density.startDensity(material));
    for (int b = 0; b < bands; ++b)
    {
      const double e = throughput[b] * gathered * material.exitance[b];
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
    return false;
  // More than roulette on the throughput alone would keep: ending paths early is what costs variance at edges. Ten
  // times saved a sixth of the time along an edge and cost a twelfth on a floor, against three times.
  const double kept = this->Alone ? keptAlone : 5;
  auto survives = [&] {
    const double survival = std::min(1.0, kept * luminous);
    if (random.next() >= survival)
      return false;
    for (int b = 0; b < bands; ++b)
      throughput[b] /= survival;
    return true;
  };
  if (!first && !survives())
    return false;
  const Bands direct = this->Luminaires.sample(next, random);
  for (int b = 0; b < bands; ++b)
    sum[b] += throughput[b] * direct[b];
  this->addVertexLight(next, pool, rayBlock, random, throughput, sum);
  if (whole && this->Mirrored.any())
  {
    // Vertices lit from a point by mirrors score elsewhere at full weight, but nowhere by a mirror again.
    const Bands images = this->Mirrored.illuminance(next);
    for (int b = 0; b < bands; ++b)
      sum[b] += throughput[b] * images[b];
  }
  if (first && !survives())
    return false;
  chain.at = next;
  chain.share = later;
  chain.seesEmission = true;
  chain.first = false;
  return true;
}

void Gathering::addVertexLight(const Sensor& sensor, const GatherPool& pool, int blockSize, SampleStream& random,
                               const Bands& throughput, Bands& sum) const
{
  if (this->Alone)
    return;
  const double share = this->blockShare(pool.trajectories, blockSize);
  Bands vertices{};
  this->scoreBlock(sensor, pool.vertices->reflected, blockSize, share, random, vertices);
  this->scoreBlock(sensor, pool.vertices->glossy, blockSize, share, random, vertices);
  this->scoreBlock(sensor, pool.vertices->emitted, blockSize, share, random, vertices);
  for (int b = 0; b < this->Lit.bands(); ++b)
    sum[b] += throughput[b] * vertices[b] / pool.trajectories;
}

void Gathering::scoreBlock(const Sensor& sensor, const VertexSet& set, int blockSize, double share,
                           SampleStream& random, Bands& sum) const
{
  if (set.size() == 0)
    return;
  // A run of vertices from a random start, around the end: each is in it with the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size);
  Bands scores{};
  auto score = [&](std::size_t from, std::size_t count) {
    const ShadowPicks shadows{this->Shadows ? &this->Lit.rays() : nullptr, this->Picks, random.next()};
    addPickedScores(set, from, static_cast<int>(count), sensor, share, shadows, scores.data());
  };
  score(begin, straight);
  if (straight < size)
    score(0, size - straight);
  for (int b = 0; b < this->Lit.bands(); ++b)
    sum[b] += weight * scores[b];
}
}  // namespace kalos
