// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/GatherWave.h"

#include <cmath>

#include "estimator/PickedScores.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
// The chance that a path goes on, over its throughput: more than roulette on the throughput alone would keep, for
// ending paths early is what costs variance at edges. Ten times saved a sixth of the time along an edge and cost a
// twelfth on a floor, against three times.
constexpr double kept = 5;
// The same when it is alone: in a white furnace 10 took three times the time of 20 to the same error, in rooms that are
// luminous in part 20 a quarter more than 5.
constexpr double keptAlone = 20;
}  // namespace

std::size_t GatherWave::add(const Sensor& sensor, const Start& start, const SampleStream& random, bool first)
{
  this->Chains.push_back({sensor, random, uniformBands(1), start.share, start.seesEmission, start.alone, first, {}});
  this->Found.resize(2 * this->Count * this->Chains.size(), 0);
  return this->Chains.size() - 1;
}

std::size_t GatherWave::gather(const Sensor& sensor, const Start& start, const SampleStream& random)
{
  const std::size_t i = this->add(sensor, start, random, true);
  this->Going.push_back(i);
  return i;
}

std::size_t GatherWave::follow(const Sensor& sensor, const Vec3& direction, const SurfacePoint& y, const Start& start,
                               const SampleStream& random)
{
  const std::size_t i = this->add(sensor, start, random, true);
  this->Chains[i].look = {direction, dot(direction, sensor.normal) / pi, false};
  if (this->advance(i, y))
    this->Going.push_back(i);
  return i;
}

std::size_t GatherWave::indirectLight(const Sensor& sensor, bool alone, const SampleStream& random)
{
  const double share = this->Rays.blockShare(this->Pool.trajectories, cellBlock);
  const std::size_t i = this->add(sensor, {share, true, alone}, random, false);
  this->addVertices(i, cellBlock);
  this->Going.push_back(i);
  return i;
}

void GatherWave::run()
{
  const Scene& scene = this->Rays.scene();
  std::vector<RayOnItsWay> rays;
  auto keepThose = [this](auto&& goesOn) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < this->Going.size(); ++k)
      if (goesOn(k))
        this->Going[kept++] = this->Going[k];
    this->Going.resize(kept);
  };
  while (!this->Going.empty())
  {
    // Find what the sensors see in a direction of their response.
    rays.clear();
    keepThose([&](std::size_t k) {
      Chain& chain = this->Chains[this->Going[k]];
      if (!this->draw(chain))
        return false;
      rays.push_back({chain.at.anchor, chain.look.direction, chain.alone, {}});
      return true;
    });
    traceTogether(scene, rays);
    keepThose([&](std::size_t k) { return this->advance(this->Going[k], rays[k].end); });
    this->addSeen();
  }
  this->addSeen();  // of rays that were given
}

void GatherWave::clear()
{
  this->Chains.clear();
  this->Found.clear();
}

bool GatherWave::draw(Chain& chain) const
{
  const Sensor& sensor = chain.at;
  const double u1 = chain.random.next(), u2 = chain.random.next();
  if (!sensor.brdf)
  {
    const Vec3 direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    chain.look = {direction, dot(direction, sensor.normal) / pi, false};
    return chain.look.density > 0;
  }
  const Bands white = uniformBands(1);
  const BrdfSample sample = sensor.brdf->sample(sensor.normal, sensor.outgoing, white, chain.random.next(), u1, u2);
  if (!sample.alive || (sample.mirror && !sensor.followsMirror))
    return false;
  chain.look = {sample.direction, sample.density, sample.mirror};
  const int bands = this->Rays.scene().bands();
  double share = 1;  // vertices do not score on a mirror
  if (!sample.mirror && !std::isinf(sensor.ratio))
  {
    const Bands f = sensor.brdf->timesPi(sensor.normal, sample.direction, sensor.outgoing);
    share = gatheredShare(sensor.ratio * lobeRatio(*sensor.brdf, sensor.normal, sample.direction, f, bands));
  }
  for (int b = 0; b < bands; ++b)
    chain.throughput[b] *= share * sample.weight[b];
  return true;
}

bool GatherWave::advance(std::size_t i, const SurfacePoint& y)
{
  const Scene& scene = this->Rays.scene();
  Chain& chain = this->Chains[i];
  const Look& look = chain.look;
  if (look.mirror)
    this->Rays.luminaires().addSeen(chain.at.anchor.lifted(), look.direction, y, chain.throughput, this->found(i));
  if (!y.valid)
    return false;
  const Vec3 d = y.position - chain.at.position;
  const double squared = dot(d, d);
  const bool whole = look.mirror || std::isinf(chain.share);                      // no vertex scores there
  const double kernel = look.density * -dot(look.direction, y.normal) / squared;  // G, for a Lambertian sensor
  const double ratio =
      whole ? std::numeric_limits<double>::infinity() : kernel * chain.share / this->Rays.pilot().density(y.position, y.normal);
  this->addEmission(i, y, kernel, whole);

  // Become the sensor there: its illuminance, or its response towards here.
  Sensor next(scene.anchor(y));
  const Brdf& brdf = scene.brdf(y.triangle);
  if (brdf.isLambertian())
    for (int b = 0; b < scene.bands(); ++b)
      chain.throughput[b] *= gatheredShare(ratio) * brdf.material().reflectance[b];
  else
  {
    next.brdf = &brdf;
    next.outgoing = -look.direction;
    next.ratio = ratio;
  }
  if (!(photometric(chain.throughput, scene.bands()) > 0) || (!chain.first && !this->survives(chain)))
    return false;
  next.anchor.crowded = crowds(chain.at.anchor, squared);
  chain.alone = !isFarFrom(next.anchor, squared);
  chain.at = next;
  this->addLuminaires(i);
  this->addVertices(i, rayBlock);
  // Vertices lit from a point by mirrors score elsewhere at full weight, but nowhere by a mirror again.
  if (whole && this->Rays.mirrored().any())
    this->addWeighted(i, this->Rays.mirrored().illuminance(next));
  if (chain.first && !this->survives(chain))
    return false;
  chain.share = this->Later;
  chain.seesEmission = true;
  chain.first = false;
  return true;
}

void GatherWave::addEmission(std::size_t i, const SurfacePoint& y, double kernel, bool whole)
{
  // What is emitted, less the share that starts on meshes score.
  const Scene& scene = this->Rays.scene();
  const Chain& chain = this->Chains[i];
  const Material& material = scene.material(y.triangle);
  if (!y.front || !(chain.look.mirror || chain.seesEmission) || !(photometric(material.exitance, scene.bands()) > 0))
    return;
  const double gathered = whole ? 1 : gatheredShare(kernel * chain.share / this->Rays.pilot().startDensity(material));
  for (int b = 0; b < scene.bands(); ++b)
  {
    const double e = chain.throughput[b] * gathered * material.exitance[b];
    this->found(i)[b] += e;
    if (chain.first && !chain.look.mirror)
      this->found(i)[static_cast<int>(this->Count) + b] += e;
  }
}

bool GatherWave::survives(Chain& chain) const
{
  const int bands = this->Rays.scene().bands();
  const double survival = std::min(1.0, (this->Rays.alone() ? keptAlone : kept) * photometric(chain.throughput, bands));
  if (chain.random.next() >= survival)
    return false;
  for (int b = 0; b < bands; ++b)
    chain.throughput[b] /= survival;
  return true;
}

void GatherWave::addLuminaires(std::size_t i)
{
  Chain& chain = this->Chains[i];
  DirectLight::Sample sample;
  Bands known{};
  if (this->Rays.luminaires().propose(chain.at, chain.random, sample, known))
    this->addIfSeen(i, sample.target, sample.light);
  if (chain.at.brdf)
    this->addWeighted(i, known);
}

void GatherWave::addVertices(std::size_t i, int blockSize)
{
  if (this->Rays.alone())
    return;
  const double share = this->Rays.blockShare(this->Pool.trajectories, blockSize);
  this->addBlock(i, this->Pool.vertices->reflected, blockSize, share);
  this->addBlock(i, this->Pool.vertices->glossy, blockSize, share);
  this->addBlock(i, this->Pool.vertices->emitted, blockSize, share);
}

void GatherWave::addBlock(std::size_t i, const VertexSet& set, int blockSize, double share)
{
  if (set.size() == 0)
    return;
  static_assert(rayBlock <= VertexTile::capacity && cellBlock <= VertexTile::capacity, "a block is scored as one tile");
  // A run of vertices from a random start, around the end: each is in it with the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(this->Chains[i].random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size) / this->Pool.trajectories;
  this->addRun(i, set, begin, straight, share, weight);
  if (straight < size)
    this->addRun(i, set, 0, size - straight, share, weight);
}

void GatherWave::addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share,
                        double weight)
{
  Chain& chain = this->Chains[i];
  const double u = chain.random.next();
  PickedScore pick;
  const bool picks = this->Rays.picksVertices();
  if (!picks)
  {
    // Every pair has a shadow ray of its own, or none can be hidden.
    pick.light = {};
    const ShadowPicks all{this->Rays.shadows() ? &this->Rays.scene().rays() : nullptr, 0, u};
    addPickedScores(set, begin, static_cast<int>(count), chain.at, share, all, pick.light.data());
  }
  else if (!pickScore(set, begin, static_cast<int>(count), chain.at, share, u, pick))
    return;
  for (std::size_t b = 0; b < this->Count; ++b)
    pick.light[b] *= weight;
  if (picks)
    this->addIfSeen(i, pick.target, pick.light);
  else
    this->addWeighted(i, pick.light);
}

void GatherWave::addWeighted(std::size_t i, const Bands& light)
{
  for (std::size_t b = 0; b < this->Count; ++b)
    this->found(i)[b] += this->Chains[i].throughput[b] * light[b];
}

void GatherWave::addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light)
{
  const Chain& chain = this->Chains[i];
  // What is no number must not hide: it stops the run.
  if (!this->Rays.shadows() || std::isnan(light[0]))
    return this->addWeighted(i, light);
  this->Shadows.push_back({chain.at.anchor, target, chain.alone});
  this->HopeOf.push_back(i);
  for (std::size_t b = 0; b < this->Count; ++b)
    this->Hopes.push_back(chain.throughput[b] * light[b]);
}

void GatherWave::addSeen()
{
  shadowTogether(this->Rays.scene().rays(), this->Shadows);
  for (std::size_t k = 0; k < this->Shadows.size(); ++k)
    for (std::size_t b = 0; b < this->Count && !this->Shadows[k].hidden; ++b)
      this->found(this->HopeOf[k])[b] += this->Hopes[k * this->Count + b];
  this->Shadows.clear();
  this->Hopes.clear();
  this->HopeOf.clear();
}
}  // namespace kalos
