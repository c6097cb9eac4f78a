// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/Highlights.h"

#include <algorithm>

namespace kalos
{
namespace
{
constexpr std::size_t mostTogether = 8;  // luminaires that are all weighed; of more, one is drawn by its flux
constexpr double evenShare = 0.1;        // of the choice among lamps and planes, for what their weights miss

double square(double x)
{
  return x * x;
}

// Density of a point of a plane that is lit evenly below a source at this height and distance, 1/m2.
double evenDensity(double height, double distance)
{
  return height / (2 * pi * distance * distance * distance);
}
}  // namespace

// A point of a lamp above a plane, on the sensor's side, and where and how far about the mirror point to look.
struct Highlights::Candidate
{
  std::size_t luminaire, plane;
  Vec3 lamp;
  Vec3 normal;                      // of the plane, towards lamp and sensor
  Vec3 middle;                      // where the sensor sees the image of the lamp
  Vec3 along, across;               // unit, in the plane
  double length, width;             // of the lobe there, m
  double lampHeight, sensorHeight;  // m
  double weight;

  double density(const Vec3& y, const Vec3& sensor) const
  {
    const Vec3 d = y - this->middle;
    const double q2 = square(dot(d, this->along) / this->length) + square(dot(d, this->across) / this->width);
    return 0.5 / (pi * this->length * this->width * square(1 + q2)) +
           0.25 * (evenDensity(this->lampHeight, kalos::length(this->lamp - y)) +
                   evenDensity(this->sensorHeight, kalos::length(sensor - y)));
  }

  Vec3 draw(const Vec3& sensor, double u0, double u1, double u2) const
  {
    const double phi = 2 * pi * u2, c = std::cos(phi), s = std::sin(phi);
    if (u0 < 0.5)
    {
      const double q = std::sqrt(u1 / (1 - u1));
      return this->middle + (q * c * this->length) * this->along + (q * s * this->width) * this->across;
    }
    // Uniform directions below a source at this height: the tangent of the angle is sqrt(1/z^2 - 1).
    const bool fromLamp = u0 < 0.75;
    const Vec3& source = fromLamp ? this->lamp : sensor;
    const double height = fromLamp ? this->lampHeight : this->sensorHeight, z = 1 - u1;
    const double r = height * std::sqrt(std::max(0.0, 1 / (z * z) - 1));
    return source - height * this->normal + (r * c) * this->along + (r * s) * this->across;
  }
};

class Highlights::Choice
{
public:
  void add(const Candidate& one)
  {
    this->Total += one.weight;
    this->All.push_back(one);
  }
  void clear()
  {
    this->All.clear();
    this->Total = 0;
  }
  bool empty() const { return this->All.empty(); }

  // One of them by u, and its probability.
  const Candidate& draw(double u, double& probability) const
  {
    const double even = evenShare / static_cast<double>(this->All.size());
    double reached = 0;
    for (const Candidate& one : this->All)
    {
      probability = even + (1 - evenShare) * (this->Total > 0 ? one.weight / this->Total : 1.0 / this->All.size());
      reached += probability;
      if (u < reached)
        return one;
    }
    return this->All.back();
  }

private:
  std::vector<Candidate> All;
  double Total = 0;
};

Highlights::Highlights(const Scene& scene, bool enabled, bool shadows)
    : Scene_(scene),
      Enabled(enabled && scene.glossyPlanes().any() && !scene.data().luminaires.empty()),
      Shadows(shadows)
{
  const auto& luminaires = scene.data().luminaires;
  if (!this->Enabled || luminaires.size() <= mostTogether)
    return;
  double sum = 0;
  for (const Luminaire& l : luminaires)
    this->Cumulative.push_back(sum += l.flux);
  this->Enabled = sum > 0;
}

void Highlights::addCandidates(const Sensor& sensor, std::size_t luminaire, const Vec3& lamp, Choice& choice) const
{
  const Luminaire& l = this->Scene_.data().luminaires[luminaire];
  const auto& planes = this->Scene_.glossyPlanes().planes();
  const double smallest = 1e-9 * this->Scene_.size();
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    const GlossyPlane& plane = planes[k];
    const double h = dot(lamp - plane.point, plane.axes.n), g = dot(sensor.position - plane.point, plane.axes.n);
    if (!(h * g > 0 && std::abs(h) > smallest && std::abs(g) > smallest))
      continue;
    Candidate one{luminaire,   k,           lamp, h > 0 ? plane.axes.n : -plane.axes.n, {}, {}, {}, 0, 0,
                  std::abs(h), std::abs(g), 0};
    const Vec3 foot = lamp - h * plane.axes.n, way = sensor.position - g * plane.axes.n - foot;
    const double away = length(way), heights = one.lampHeight + one.sensorHeight;
    const double distance = std::hypot(away, heights), cosine = heights / distance;
    one.middle = foot + (one.lampHeight / heights) * way;
    one.along = away > 1e-9 * heights ? (1 / away) * way : plane.axes.s;
    one.across = cross(one.normal, one.along);
    one.width = plane.brdf->lobeWidth() * 2 * one.lampHeight * one.sensorHeight / heights;
    one.length = one.width / (cosine * cosine);

    // What the image sends, less where the mirror point lies beside the surface.
    const Vec3 local = plane.axes.toLocal(one.middle - plane.point);
    const double x = local.x - std::clamp(local.x, plane.low[0], plane.high[0]);
    const double y = local.y - std::clamp(local.y, plane.low[1], plane.high[1]);
    const Vec3 beside = x * plane.axes.s + y * plane.axes.t;
    const double q2 = square(dot(beside, one.along) / one.length) + square(dot(beside, one.across) / one.width);
    const Vec3 fromImage = (1 / distance) * (away * one.along + heights * one.normal);  // towards the sensor
    const Vec3 emitted = (1 / distance) * (away * one.along - heights * one.normal);
    const double arriving = 0.1 + std::max(0.0, -dot(fromImage, sensor.normal));
    one.weight = (intensity(l, emitted) + 0.1 * l.flux / (4 * pi)) * arriving * plane.brdf->lobeAlbedo(cosine) /
                 (distance * distance * square(1 + q2));
    choice.add(one);
  }
}

Bands Highlights::sample(const Sensor& sensor, SampleStream& random) const
{
  thread_local Choice choice;
  choice.clear();
  const double u0 = random.next(), u1 = random.next(), u2 = random.next(), u3 = random.next();
  const double place1 = random.next(), place2 = random.next(), u4 = random.next();
  const auto& luminaires = this->Scene_.data().luminaires;
  auto pointOf = [&](const Luminaire& l) {
    return l.isPoint() ? l.position : l.position + (place1 - 0.5) * l.sideU + (place2 - 0.5) * l.sideV;
  };
  double share = 1;
  if (this->Cumulative.empty())
    for (std::size_t i = 0; i < luminaires.size(); ++i)
      this->addCandidates(sensor, i, pointOf(luminaires[i]), choice);
  else
  {
    const auto found =
        std::upper_bound(this->Cumulative.begin(), this->Cumulative.end() - 1, u4 * this->Cumulative.back());
    const auto i = static_cast<std::size_t>(found - this->Cumulative.begin());
    share = luminaires[i].flux / this->Cumulative.back();
    this->addCandidates(sensor, i, pointOf(luminaires[i]), choice);
  }
  if (choice.empty())
    return {};
  double probability;
  const Candidate& one = choice.draw(u0, probability);
  const Vec3 y = one.draw(sensor.position, u1, u2, u3);
  return this->score(sensor, one, y, share * probability * one.density(y, sensor.position));
}

Bands Highlights::score(const Sensor& sensor, const Candidate& one, const Vec3& y, double density) const
{
  const Luminaire& l = this->Scene_.data().luminaires[one.luminaire];
  const GlossyPlane& plane = this->Scene_.glossyPlanes().planes()[one.plane];
  const Vec3 lamp = l.isOpening() && !isNear(l, y) ? l.position : one.lamp;
  const Vec3 toLamp = lamp - y, toSensor = sensor.position - y;
  const double lamp2 = dot(toLamp, toLamp), sensor2 = dot(toSensor, toSensor);
  const Vec3 wi = (1 / std::sqrt(lamp2)) * toLamp, wo = (1 / std::sqrt(sensor2)) * toSensor;
  const double atLamp = dot(wi, one.normal), atSensor = -dot(wo, sensor.normal);
  if (!(atSensor > 0 && atLamp > 0))
    return {};
  const double arriving = intensity(l, -wi) * atLamp / lamp2;
  const double e = arriving * plane.brdf->lobeTimesPi(one.normal, wi, wo) / pi * dot(wo, one.normal) * atSensor /
                   (sensor2 * density);
  if (!(e > 0))
    return {};

  // The glossy surface must be there and be seen, and the lamp from it.
  const SurfacePoint met = this->Scene_.trace(sensor.anchor, -wo);
  if (!met.valid || this->Scene_.glossyPlanes().of(met.triangle) != one.plane || dot(met.normal, one.normal) < 0)
    return {};
  if (this->Shadows)
  {
    const RayAnchor& end = this->Scene_.luminaireAnchor(one.luminaire);
    const Vec3 normal = dot(wi, end.normal) > 0 ? -end.normal : end.normal;
    const RayAnchor target = l.isPoint() ? end : RayAnchor(lamp, normal, end.base, end.slope);
    if (this->Scene_.rays().occluded(this->Scene_.anchor(met.triangle, y, one.normal), target))
      return {};
  }
  Bands light = response(sensor, -wo, this->Scene_.bands());
  const double apart = 1 - keptLobeShare(sensor, -wo);
  for (int b = 0; b < this->Scene_.bands(); ++b)
    light[b] *= e * apart;
  return light;
}
}  // namespace kalos
