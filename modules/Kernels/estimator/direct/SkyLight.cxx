// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/SkyLight.h"

#include "geometry/SphericalRectangle.h"
#include "sampling/Warp.h"

namespace kalos
{
namespace
{
constexpr double throughOpenings = 0.9;  // of the samples without the sun, where openings are known
constexpr double sunInside = 0.4;        // of all samples, where openings are known
constexpr double afar = 4;               // larger sides of an opening, beyond which it is sampled by area

bool isAfar(const SkyOpenings::Rectangle& r, const Vec3& p)
{
  const Vec3 d = r.corner + 0.5 * (r.u + r.v) - p;
  return dot(d, d) > afar * afar * std::max(dot(r.u, r.u), dot(r.v, r.v));
}

// What is left of u after a choice of probability p that began at `before`.
double rest(double u, double before, double p)
{
  return std::clamp((u - before) / p, 0.0, 0x1.fffffffffffffp-1);
}
}  // namespace

SkyLight::SkyLight(const Scene& scene, const SkyOpenings* openings)
    : Scene_(scene), Openings(openings && openings->any() ? openings : nullptr)
{
}

void SkyLight::mix(const Sensor& sensor, bool withSun, Mixture& mixture) const
{
  mixture.sun = mixture.opening = 0;
  mixture.cumulative.clear();
  if (this->Openings && this->Openings->encloses(sensor.position))
  {
    double sum = 0;
    const double mean = this->sky().horizontalIlluminance() / pi;
    for (const SkyOpenings::Rectangle& r : this->Openings->all())
    {
      const Vec3 d = r.corner + 0.5 * (r.u + r.v) - sensor.position;
      const double height = dot(r.corner - sensor.position, r.outward);
      const double d2 = dot(d, d), radius = 0.5 * length(r.u + r.v), distance = std::sqrt(d2) + radius;
      const double above = dot(d, sensor.normal) + radius;  // of its highest point, about
      if (above > 0 && height > 1e-9 * this->Scene_.size())
        sum += r.area * (above / distance) * ((height + 0.1 * radius) / distance) / (d2 + r.area) *
               (this->sky().luminance((1 / std::sqrt(d2)) * d) + 0.1 * mean);
      mixture.cumulative.push_back(sum);
    }
    mixture.opening = sum > 0 ? throughOpenings : 0;
  }
  if (withSun && this->sky().hasSun() && dot(sensor.normal, this->sky().sun()) > -std::sin(Sky::sunRadius))
  {
    const double light = this->sky().sunIlluminance() * std::max(0.0, dot(sensor.normal, this->sky().sun()));
    mixture.sun =
        mixture.opening > 0 ? sunInside : std::clamp(light / (light + this->sky().horizontalIlluminance()), 0.1, 0.9);
    mixture.opening *= 1 - mixture.sun;
  }
}

bool SkyLight::sample(const Sensor& sensor, const Mixture& mixture, double u0, double u1, double u2, Vec3& direction,
                      double& density) const
{
  if (u0 < mixture.sun)
    direction = this->sky().sampleSun(u1, u2);
  else if (u0 < mixture.sun + mixture.opening)
  {
    const double target = rest(u0, mixture.sun, mixture.opening) * mixture.openings();
    const auto found = std::upper_bound(mixture.cumulative.begin(), mixture.cumulative.end(), target);
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(found - mixture.cumulative.begin()),
                                                mixture.cumulative.size() - 1);
    const SkyOpenings::Rectangle& r = this->Openings->all()[i];
    const Vec3 point = isAfar(r, sensor.position)
                           ? r.corner + u1 * r.u + u2 * r.v
                           : SphericalRectangle(sensor.position, r.corner, r.u, r.v).sample(u1, u2);
    direction = normalized(point - sensor.position);
  }
  else if (rest(u0, mixture.sun + mixture.opening, 1 - mixture.sun - mixture.opening) < 0.5 ||
           this->sky().directions().isEmpty())
    direction = Frame(sensor.normal).toWorld(cosineHemisphere(u1, u2));
  else
    direction = this->sky().directions().sample(u1, u2);
  if (!(dot(direction, sensor.normal) > 0))
    return false;
  density = this->density(sensor, mixture, direction);
  return density > 0;
}

double SkyLight::openingDensity(const SkyOpenings::Rectangle& r, const Vec3& from, const Vec3& direction) const
{
  if (!isAfar(r, from))
    return 1 / std::max(1e-300, SphericalRectangle(from, r.corner, r.u, r.v).solidAngle());
  const double facing = dot(direction, r.outward), distance = dot(r.corner - from, r.outward) / facing;
  return distance * distance / (r.area * facing);
}

double SkyLight::density(const Sensor& sensor, const Mixture& mixture, const Vec3& direction) const
{
  double sum = mixture.sun > 0 && this->sky().inDisc(direction) ? mixture.sun / Sky::sunSolidAngle : 0;
  Vec3 point;
  const int face = mixture.opening > 0 ? this->Openings->exit(sensor.position, direction, point) : -1;
  for (std::size_t i = 0; face >= 0 && i < mixture.cumulative.size(); ++i)
    if (mixture.share(i) > 0 && this->Openings->covers(i, face, point))
      sum += mixture.opening * mixture.share(i) / mixture.openings() *
             this->openingDensity(this->Openings->all()[i], sensor.position, direction);
  const double general = 1 - mixture.sun - mixture.opening;
  const double cosine = std::max(0.0, dot(direction, sensor.normal)) / pi;
  const DirectionTable& directions = this->sky().directions();
  return sum + general * (directions.isEmpty() ? cosine : 0.5 * (cosine + directions.density(direction)));
}
}  // namespace kalos
