// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/WavefrontGather.h"

#include <cmath>

#include "estimator/kernel/VertexResampling.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
// Survival probability of a path over its throughput. It is above 1, because ending paths early costs variance at
// edges. Ten times saved a sixth of the time along an edge and cost a twelfth on a floor, against three times.
constexpr double kept = 5;
// The same without vertices, with next event estimation: on a plane in a furnished room 5 and 20 took a fifth more time
// to the same error.
constexpr double keptNextEvents = 10;
// The same where paths meet all light themselves: in a white furnace 10 took three times the time of 20 to the same
// error, in rooms that are luminous in part 20 a quarter more than 5.
constexpr double keptPathsOnly = 20;
}  // namespace

std::size_t WavefrontGather::add(const Sensor& sensor, const Start& start, const SampleStream& random, bool first)
{
  this->Paths.push_back({sensor,
                         random,
                         uniformBands(1),
                         start.share,
                         start.share,
                         start.seesEmission,
                         start.doublePrecision,
                         first,
                         {}});
  this->Found.resize(2 * this->Count * this->Paths.size(), 0);
  this->Picked.emplace_back();
  return this->Paths.size() - 1;
}

std::size_t WavefrontGather::gather(const Sensor& sensor, const Start& start, const SampleStream& random)
{
  const std::size_t i = this->add(sensor, start, random, true);
  this->Active.push_back(i);
  return i;
}

std::size_t WavefrontGather::follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y,
                                    const Start& start, const SampleStream& random)
{
  const std::size_t i = this->add(sensor, start, random, true);
  this->Paths[i].sampled = {direction, dot(direction, sensor.normal) / pi, false};
  if (this->advance(i, y))
    this->Active.push_back(i);
  return i;
}

std::size_t WavefrontGather::indirectLight(const Sensor& sensor, bool doublePrecision, const SampleStream& random)
{
  const double share = this->Rays.blockShare(this->Pool.trajectories, cellBlock);
  const std::size_t i = this->add(sensor, {share, true, doublePrecision}, random, false);
  this->addVertices(i, cellBlock, true);
  this->Active.push_back(i);
  return i;
}

void WavefrontGather::run()
{
  const Scene& scene = this->Rays.scene();
  std::vector<PathRay> rays;
  auto keepThose = [this](auto&& goesOn) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < this->Active.size(); ++k)
      if (goesOn(k))
        this->Active[kept++] = this->Active[k];
    this->Active.resize(kept);
  };
  while (!this->Active.empty())
  {
    // Trace rays in directions drawn from the sensors' response.
    rays.clear();
    keepThose([&](std::size_t k) {
      PathState& path = this->Paths[this->Active[k]];
      if (!this->draw(path))
        return false;
      rays.push_back({path.at.anchor, path.sampled.direction, path.doublePrecision, {}});
      return true;
    });
    traceTogether(scene, rays);
    keepThose([&](std::size_t k) { return this->advance(this->Active[k], rays[k].end); });
    this->addSeen();
  }
  this->addSeen();  // of rays that were given
}

void WavefrontGather::clear()
{
  this->Paths.clear();
  this->Found.clear();
  this->Picked.clear();
}

bool WavefrontGather::draw(PathState& path) const
{
  const Sensor& sensor = path.at;
  const double u1 = path.random.next(), u2 = path.random.next();
  if (!sensor.brdf)
  {
    const Vec3 direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    path.sampled = {direction, dot(direction, sensor.normal) / pi, false};
    return path.sampled.density > 0;
  }
  const Bands white = uniformBands(1);
  const BrdfSample sample = sensor.brdf->sample(sensor.normal, sensor.outgoing, white, path.random.next(), u1, u2);
  if (!sample.alive || (sample.mirror && !sensor.followsMirror))
    return false;
  path.sampled = {sample.direction, sample.density, sample.mirror};
  const int bands = this->Rays.scene().bands();
  double share = 1;  // vertices do not score on a mirror
  if (!sample.mirror && !std::isinf(sensor.ratio))
  {
    const Bands f = sensor.brdf->timesPi(sensor.normal, sample.direction, sensor.outgoing);
    share = gatheredShare(sensor.ratio * lobeRatio(*sensor.brdf, sensor.normal, sample.direction, f, bands));
  }
  for (int b = 0; b < bands; ++b)
    path.throughput[b] *= share * sample.weight[b];
  return true;
}

bool WavefrontGather::advance(std::size_t i, const SurfacePoint& y)
{
  const Scene& scene = this->Rays.scene();
  PathState& path = this->Paths[i];
  const DirectionSample& sampled = path.sampled;
  if (sampled.mirror)
    this->Rays.luminaires().addSeen(path.at.anchor.lifted(), sampled.direction, y, path.throughput, this->found(i));
  if (!y.valid)
    return false;
  const Vec3 d = y.position - path.at.position;
  const double squared = dot(d, d);
  const bool whole = sampled.mirror || std::isinf(path.share);                          // no vertex scores there
  const double kernel = sampled.density * -dot(sampled.direction, y.normal) / squared;  // G, for a Lambertian sensor
  const double ratio =
      whole ? std::numeric_limits<double>::infinity() : kernel * path.share / this->Rays.pilot().density(y.position);
  this->addEmission(i, y, kernel);

  // The hit becomes the next sensor: for illuminance, or for its response towards the previous one.
  Sensor next(scene.anchor(y));
  const Brdf& brdf = scene.brdf(y.triangle);
  if (brdf.isLambertian())
    for (int b = 0; b < scene.bands(); ++b)
      path.throughput[b] *= gatheredShare(ratio) * brdf.material().reflectance[b];
  else
  {
    next.brdf = &brdf;
    next.outgoing = -sampled.direction;
    next.ratio = ratio;
  }
  if (!(photometric(path.throughput, scene.bands()) > 0) || (!path.first && !this->survives(path)))
    return false;
  next.anchor.crowded = crowds(path.at.anchor, squared);
  path.doublePrecision = !isFarFrom(next.anchor, squared);
  path.at = next;
  this->addLuminaires(i, ratio);
  this->addVertices(i, rayBlock);
  // Add point luminaires seen by mirrors only where no vertex scores; elsewhere vertices include that light.
  if (whole && this->Rays.mirrored().any())
    this->addWeighted(i, this->Rays.mirrored().illuminance(next));
  if (path.first && !this->survives(path))
    return false;
  path.share = this->Later;
  path.startShare = this->LaterStarts;
  path.seesEmission = true;
  path.first = false;
  return true;
}

void WavefrontGather::addEmission(std::size_t i, const SurfacePoint& y, double kernel)
{
  // The exitance, less the part scored by trajectory starts on meshes.
  const Scene& scene = this->Rays.scene();
  const PathState& path = this->Paths[i];
  const Material& material = scene.material(y.triangle);
  if (!y.front || !(path.sampled.mirror || path.seesEmission) || !(photometric(material.exitance, scene.bands()) > 0))
    return;
  const bool whole = path.sampled.mirror || std::isinf(path.startShare);  // no start scores there
  const double gathered =
      whole ? 1 : gatheredShare(kernel * path.startShare / this->Rays.pilot().startDensity(material));
  for (int b = 0; b < scene.bands(); ++b)
  {
    const double e = path.throughput[b] * gathered * material.exitance[b];
    this->found(i)[b] += e;
    if (path.first && !path.sampled.mirror)
      this->found(i)[static_cast<int>(this->Count) + b] += e;
  }
}

bool WavefrontGather::survives(PathState& path) const
{
  const int bands = this->Rays.scene().bands();
  const double factor = !this->Rays.pathsOnly() ? kept : this->Rays.usesStarts() ? keptNextEvents : keptPathsOnly;
  const double survival = std::min(1.0, factor * photometric(path.throughput, bands));
  if (path.random.next() >= survival)
    return false;
  for (int b = 0; b < bands; ++b)
    path.throughput[b] /= survival;
  return true;
}

void WavefrontGather::addLuminaires(std::size_t i, double ratio)
{
  PathState& path = this->Paths[i];
  DirectLight::Sample sample;
  Bands known{};
  if (this->Rays.luminaires().sampleUnshadowed(path.at, path.random, sample, known))
  {
    const double share = path.at.brdf ? 1 : this->Rays.luminaireShare(path.at, sample.luminaire, ratio);
    for (std::size_t b = 0; b < this->Count; ++b)
      sample.light[b] *= share;
    this->addIfSeen(i, sample.target, sample.light);
  }
  if (path.at.brdf)
    this->addWeighted(i, known);
}

void WavefrontGather::addVertices(std::size_t i, int blockSize, bool counted)
{
  const LightVertices& pool = *this->Pool.vertices;
  const int trajectories = this->Pool.trajectories;
  if (!this->Rays.pathsOnly())
    for (const VertexSet* set : {&pool.reflected, &pool.glossy})
      this->addBlock(i, *set, blockSize, this->Rays.blockShare(trajectories, blockSize), counted);
  if (this->Rays.usesStarts())
    this->addBlock(i, pool.emitted, blockSize, this->Rays.startShare(trajectories, blockSize), counted);
}

void WavefrontGather::addBlock(std::size_t i, const VertexSet& set, int blockSize, double share, bool counted)
{
  if (set.size() == 0)
    return;
  static_assert(rayBlock <= VertexTile::capacity && cellBlock <= VertexTile::capacity, "a block is scored as one tile");
  // A run of vertices from a random start, wrapped at the end, so that each vertex has the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(this->Paths[i].random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size) / this->Pool.trajectories;
  this->addRun(i, set, begin, straight, share, weight, counted);
  if (straight < size)
    this->addRun(i, set, 0, size - straight, share, weight, counted);
}

void WavefrontGather::addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share,
                             double weight, bool counted)
{
  PathState& path = this->Paths[i];
  const double u = path.random.next();
  ResampledScore pick;
  const bool picks = this->Rays.picksVertices();
  if (!picks)
  {
    // Every pair has a shadow ray of its own, or none can be hidden.
    pick.light = {};
    const ShadowPicks all{this->Rays.shadows() ? &this->Rays.scene().rays() : nullptr, 0, u};
    addResampledScores(set, begin, static_cast<int>(count), path.at, share, all, pick.light.data());
  }
  else if (!resampleOne(set, begin, static_cast<int>(count), path.at, share, u, pick))
    return;
  for (std::size_t b = 0; b < this->Count; ++b)
    pick.light[b] *= weight;
  if (picks)
    this->addIfSeen(i, pick.target, pick.light, counted);
  else
    this->addWeighted(i, pick.light);
}

void WavefrontGather::addWeighted(std::size_t i, const Bands& light)
{
  for (std::size_t b = 0; b < this->Count; ++b)
    this->found(i)[b] += this->Paths[i].throughput[b] * light[b];
}

void WavefrontGather::addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light, bool counted)
{
  const PathState& path = this->Paths[i];
  // A NaN skips the shadow test, so that checkFinite() reports it.
  if (!this->Rays.shadows() || std::isnan(light[0]))
    return this->addWeighted(i, light);
  this->Pending.add(i, {path.at.anchor, target, path.doublePrecision}, path.throughput, light, counted);
  if (counted)
    this->Picked[i].add({photometric(light, static_cast<int>(this->Count)), 1, 0});
}

void WavefrontGather::addSeen()
{
  this->Pending.settle(this->Rays.scene().rays(), [this](std::size_t i, const double* light, bool counted) {
    for (std::size_t b = 0; b < this->Count; ++b)
      this->found(i)[b] += light[b];
    this->Picked[i].seen += counted ? 1 : 0;
  });
}
}  // namespace kalos
