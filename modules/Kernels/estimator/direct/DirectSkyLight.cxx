// SPDX-License-Identifier: BSD-3-Clause
// The sky's part of DirectLight::sample().
#include "estimator/direct/DirectLight.h"

namespace kalos
{
bool DirectLight::aim(const Sensor& sensor, SampleStream& random, AreaSample& sample, Bands& arriving,
                      Bands& lobe) const
{
  if (!this->FromSky.any())
    return this->aimAtLuminaire(sensor, random, sample, arriving, lobe);
  if (this->Scene_.data().luminaires.empty())
    return this->aimAtSky(sensor, random, sample, arriving, lobe);
  // Ask one of the two.
  Bands found{};
  const bool aimed = random.next() < 0.5 ? this->aimAtSky(sensor, random, sample, arriving, found)
                                         : this->aimAtLuminaire(sensor, random, sample, arriving, found);
  for (int b = 0; b < this->Scene_.bands(); ++b)
  {
    arriving[b] *= 2;
    lobe[b] += 2 * found[b];
  }
  return aimed;
}

bool DirectLight::aimAtSky(const Sensor& sensor, SampleStream& random, AreaSample& sample, Bands& arriving,
                           Bands& lobe) const
{
  const Sky& sky = this->FromSky.sky();
  thread_local SkyLight::Mixture mixture;
  this->FromSky.mix(sensor, true, mixture);
  const double u0 = random.next(), u1 = random.next(), u2 = random.next();
  if (sensor.brdf)
    this->sampleSkyByLobe(sensor, random, mixture, lobe);
  double density;
  if (!this->FromSky.sample(sensor, mixture, u0, u1, u2, sample.direction, density))
    return false;
  if (sensor.brdf)  // MIS with the lobe's sample: balance heuristic
    density += gatherDensity(sensor, sample.direction);
  sample.luminaire = skyLight;
  sample.target = this->FromSky.target(sensor.position, sample.direction);
  const double light = sky.luminanceWithSun(sample.direction) * dot(sample.direction, sensor.normal) / density;
  arriving = uniformBands(light);
  return light > 0;
}

void DirectLight::sampleSkyByLobe(const Sensor& sensor, SampleStream& random, const SkyLight::Mixture& mixture,
                                  Bands& sum) const
{
  const double u0 = random.next(), u1 = random.next(), u2 = random.next();
  const BrdfSample ray = sensor.brdf->sample(sensor.normal, sensor.outgoing, uniformBands(1), u0, u1, u2);
  if (!ray.alive || ray.mirror)
    return;
  const double visible = this->visibility(sensor.anchor, this->FromSky.target(sensor.position, ray.direction));
  const Bands weight = response(sensor, ray.direction, this->Scene_.bands());
  const double density = this->FromSky.density(sensor, mixture, ray.direction) + ray.density;
  const double light =
      visible * this->FromSky.sky().luminanceWithSun(ray.direction) * dot(ray.direction, sensor.normal) / density;
  for (int b = 0; b < this->Scene_.bands(); ++b)
    sum[b] += weight[b] * light;
}
}  // namespace kalos
