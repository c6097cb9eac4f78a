// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/ReceiverSkyLight.h"

#include "estimator/tracing/VertexRound.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr int pilotSamples = 16;
constexpr std::size_t mostNormals = 64;  // whose unobstructed illuminance is integrated
constexpr double leastVisible = 0.5;     // share from which the unobstructed illuminance is worth its use
}  // namespace

ReceiverSkyLight::ReceiverSkyLight(const Scene& scene, const SkyOpenings* openings, const Walks& walks,
                                   bool closedForms)
    : Scene_(scene), Light(scene, openings), Drawn(walks), ClosedForms(closedForms)
{
}

void ReceiverSkyLight::start(const std::vector<Sensor>& sensors)
{
  if (!this->any())
    return;
  this->Views.resize(sensors.size());
  this->Normals.clear();
  for (const Sensor& sensor : sensors)
  {
    const Vec3& n = sensor.normal;
    const bool known = std::any_of(this->Normals.begin(), this->Normals.end(),
                                   [&](const Vec3& m) { return m.x == n.x && m.y == n.y && m.z == n.z; });
    if (!known)
      this->Normals.push_back(n);
    if (this->Normals.size() <= mostNormals)
      continue;
    this->Normals.clear();
    break;
  }
  this->Unobstructed.clear();
  for (const Vec3& n : this->Normals)
    this->Unobstructed.push_back(this->ClosedForms ? this->Light.sky().illuminance(n) : 0);
}

double ReceiverSkyLight::fixed(std::size_t r) const
{
  const View& view = this->Views[r];
  return view.visibleSky * view.sky + view.visibleSun * view.sun;
}

double ReceiverSkyLight::prepare(std::size_t r, const Sensor& sensor)
{
  View& view = this->Views[r];
  this->Light.mix(sensor, false, view.mixture);
  const Sky& sky = this->Light.sky();
  const double height = dot(sky.sun(), sensor.normal), edge = std::sin(Sky::sunRadius);
  view.seesSun = sky.hasSun() && height > -edge;
  const bool whole = height > edge && sky.sun().z > edge;
  const Walks walks = this->Drawn.ofReceiver(r);
  double sunSeen = 0, skySeen = 0;
  for (int s = 0; s < pilotSamples; ++s)
  {
    SampleStream random = walks.stream(pilotReplicate, Purpose::Sky, s);
    const double u1 = random.next(), u2 = random.next();
    const Vec3 direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
    skySeen += this->visibility(sensor, direction);
    double w;
    if (view.seesSun)
      sunSeen += this->sampleSun(sensor, random.next(), random.next(), w);
  }
  const double share = skySeen / pilotSamples;
  if (share > leastVisible)
  {
    view.mixture.opening = 0;  // it is open nearly everywhere
    const auto known = std::find_if(this->Normals.begin(), this->Normals.end(), [&](const Vec3& m) {
      return m.x == sensor.normal.x && m.y == sensor.normal.y && m.z == sensor.normal.z;
    });
    if (known != this->Normals.end())
      view.sky = this->Unobstructed[static_cast<std::size_t>(known - this->Normals.begin())];
    view.visibleSky = view.sky > 0 ? share : 0;
  }
  if (this->ClosedForms && view.seesSun && whole)
  {
    view.sun = sky.sunIlluminance() * height;
    view.visibleSun = sunSeen / pilotSamples;
  }
  view.steady = view.visibleSky == 1 && (!view.seesSun || view.visibleSun == 0 || view.visibleSun == 1);
  return this->fixed(r);
}

double ReceiverSkyLight::sampleSky(const View& view, const Sensor& sensor, SampleStream& random, double& w) const
{
  const double u0 = random.next(), u1 = random.next(), u2 = random.next();
  Vec3 direction;
  double density;
  w = 0;
  if (!this->Light.sample(sensor, view.mixture, u0, u1, u2, direction, density))
    return 0;
  w = this->Light.sky().luminance(direction) * dot(direction, sensor.normal) / density;
  return w > 0 ? this->visibility(sensor, direction) : 0;
}

double ReceiverSkyLight::visibility(const Sensor& sensor, const Vec3& direction) const
{
  const RayAnchor target = this->Light.target(sensor.position, direction);
  const RayScene& rays = this->Scene_.rays();
  return rays.occluded(sensor.anchor, target) ? 0 : rays.transmittance(sensor.anchor, target);
}

double ReceiverSkyLight::sampleSun(const Sensor& sensor, double u1, double u2, double& w) const
{
  const Vec3 direction = this->Light.sky().sampleSun(u1, u2);
  const double cosine = dot(direction, sensor.normal);
  w = 0;
  if (!(cosine > 0) || !(direction.z > 0))
    return 0;
  w = this->Light.sky().sunLuminance() * Sky::sunSolidAngle * cosine;
  return this->visibility(sensor, direction);
}

double ReceiverSkyLight::sample(std::size_t r, const Sensor& sensor, SampleStream& random) const
{
  const View& view = this->Views[r];
  double w;
  const double visible = this->sampleSky(view, sensor, random, w);
  double sum = w * (visible - view.visibleSky);
  if (view.seesSun)
  {
    const double u1 = random.next(), u2 = random.next();
    const double seen = this->sampleSun(sensor, u1, u2, w);
    sum += w * (seen - view.visibleSun);
  }
  return sum;
}
}  // namespace kalos
