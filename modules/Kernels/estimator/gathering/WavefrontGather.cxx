// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/WavefrontGather.h"

#include <cmath>

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
                         uniformBands(start.factor),
                         start.share,
                         start.share,
                         start.seesEmission,
                         start.doublePrecision,
                         start.lobeOnly,
                         first,
                         {}});
  this->Found.resize(2 * this->Count * this->Paths.size(), 0);
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
  this->Paths[i].sampled = {direction, gatherDensity(sensor, direction), false, keptLobeShare(sensor, direction)};
  if (this->advance(i, y))
    this->Active.push_back(i);
  return i;
}

std::size_t WavefrontGather::indirectLight(const Sensor& sensor, bool doublePrecision, const SampleStream& random)
{
  const double share = this->Rays.blockShare(this->Pool.trajectories, cellBlock);
  const std::size_t i = this->add(sensor, {share, true, doublePrecision}, random, false);
  this->Paths[i].at.highlightsApart = this->Rays.highlights().any();
  this->addHighlights(i, 1);
  this->addVertices(i, cellBlock);
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
}

bool WavefrontGather::draw(PathState& path) const
{
  const Sensor& sensor = path.at;
  const double u1 = path.random.next(), u2 = path.random.next();
  if (!sensor.brdf)
  {
    const Vec3 direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    path.sampled = {direction, dot(direction, sensor.normal) / pi, false, keptLobeShare(sensor, direction)};
    if (sensor.diffuseOf)
      for (double& t : path.throughput)
        t *= incidence(sensor, direction);
    return path.sampled.density > 0;
  }
  const Bands white = uniformBands(1);
  double u0 = path.random.next();
  if (path.lobeOnly)
  {
    // More rays than the little that a lobe reflects would have: its error shrinks with its energy.
    const double reflected =
        sensor.brdf->material().mirror + sensor.brdf->albedo(dot(sensor.normal, sensor.outgoing), white);
    const double drawn = std::min(1.0, kept * reflected);
    if (u0 >= drawn)
      return false;
    u0 *= reflected / drawn;
    for (double& t : path.throughput)
      t *= reflected / drawn;
    path.lobeOnly = false;
  }
  const BrdfSample sample = sensor.brdf->sample(sensor.normal, sensor.outgoing, white, u0, u1, u2);
  if (!sample.alive || (sample.mirror && !sensor.followsMirror))
    return false;
  path.sampled = {sample.direction, sample.density, sample.mirror,
                  sample.mirror ? 1 : keptLobeShare(sensor, sample.direction)};
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
  next.highlightsApart = this->Rays.highlights().any();
  const Brdf& brdf = path.lobeOnly ? scene.lobe(y.triangle) : scene.brdf(y.triangle);
  if (brdf.isLambertian())
    for (int b = 0; b < scene.bands(); ++b)
      path.throughput[b] *= gatheredShare(ratio) * brdf.material().reflectance[b];
  else
  {
    next.brdf = &brdf;
    next.outgoing = -sampled.direction;
    next.ratio = ratio;
    if (scene.glossyPlanes().of(y.triangle) != GlossyPlanes::none)
      next.keptLobe = sampled.keptLobe;
  }
  if (!(photometric(path.throughput, scene.bands()) > 0) || (!path.first && !this->survives(path)))
    return false;
  next.anchor.crowded = crowds(path.at.anchor, squared);
  path.doublePrecision = !isFarFrom(next.anchor, squared);
  path.at = next;
  this->addLuminaires(i);
  this->addHighlights(i, rayHighlights);
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
}  // namespace kalos
