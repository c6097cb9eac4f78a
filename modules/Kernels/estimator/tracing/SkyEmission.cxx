// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/SkyEmission.h"

namespace kalos
{
namespace
{
constexpr double elsewhere = 0.1;  // of the lines, where openings are known
constexpr double least = 1e-3;     // of the mean luminance: no direction is left out

double rest(double u, double before, double p)
{
  return std::clamp((u - before) / p, 0.0, 0x1.fffffffffffffp-1);
}
}  // namespace

SkyEmission::SkyEmission(const Scene& scene, const SkyOpenings* openings)
    : Scene_(scene), Openings(openings && openings->any() ? openings : nullptr)
{
  if (!scene.data().sky)
    return;
  const Sky& sky = *scene.data().sky;
  for (const Vec3& p : scene.data().points)
    this->Radius = std::max(this->Radius, length(p));
  this->Radius *= 1 + 1e-6;
  const double everywhere = sky.directions().integral() + sky.sunIlluminance();
  this->All = {&sky.directions(), everywhere > 0 ? sky.sunIlluminance() / everywhere : 0};
  if (!this->Openings)
  {
    this->Flux = pi * this->Radius * this->Radius * everywhere;
    return;
  }
  double through[6] = {};
  for (const SkyOpenings::Rectangle& r : this->Openings->all())
  {
    if (!this->Faces[r.face].sky)
    {
      const double mean = sky.directions().integral() / (4 * pi);
      this->Tables.push_back(std::make_unique<DirectionTable>([&](const Vec3& direction) {
        return std::max(0.0, dot(direction, r.outward)) * (sky.luminance(direction) + least * mean);
      }));
      const double sun = sky.sunIlluminance() * std::max(0.0, dot(sky.sun(), r.outward));
      through[r.face] = this->Tables.back()->integral() + sun;
      this->Faces[r.face] = {this->Tables.back().get(), through[r.face] > 0 ? sun / through[r.face] : 0};
    }
    this->Cumulative.push_back(this->Flux += r.area * through[r.face]);
  }
  this->OfOpenings = this->Flux > 0 ? 1 - elsewhere : 0;
}

bool SkyEmission::draw(const Source& source, double u1, double u2, Vec3& direction) const
{
  if (u1 < source.sun)
    direction = this->Scene_.data().sky->sampleSun(rest(u1, 0, source.sun), u2);
  else if (source.sky->isEmpty())
    return false;
  else
    direction = source.sky->sample(rest(u1, source.sun, 1 - source.sun), u2);
  return true;
}

double SkyEmission::density(const Source& source, const Vec3& direction) const
{
  const double sun = source.sun > 0 && this->Scene_.data().sky->inDisc(direction) ? source.sun / Sky::sunSolidAngle : 0;
  return sun + (1 - source.sun) * source.sky->density(direction);
}

double SkyEmission::density(const Vec3& p, const Vec3& direction) const
{
  double sum = (1 - this->OfOpenings) * this->density(this->All, direction) / (pi * this->Radius * this->Radius);
  Vec3 point;
  const int face = this->OfOpenings > 0 ? this->Openings->exit(p, direction, point) : -1;
  if (face < 0 || !this->Faces[face].sky)
    return sum;
  double each = -1;  // of the directions
  for (std::size_t i = 0; i < this->Cumulative.size(); ++i)
  {
    if (!this->Openings->covers(i, face, point))
      continue;
    const SkyOpenings::Rectangle& r = this->Openings->all()[i];
    const double share = (this->Cumulative[i] - (i ? this->Cumulative[i - 1] : 0)) / this->Flux;
    if (each < 0)
      each = this->density(this->Faces[face], direction);
    sum += this->OfOpenings * share * each / (r.area * dot(direction, r.outward));
  }
  return sum;
}

SkyEmission::Line SkyEmission::sample(double u0, double u1, double u2, double u3, double u4) const
{
  const Sky& sky = *this->Scene_.data().sky;
  Vec3 direction, point;
  if (u0 < this->OfOpenings)
  {
    const double target = rest(u0, 0, this->OfOpenings) * this->Flux;
    const auto found = std::upper_bound(this->Cumulative.begin(), this->Cumulative.end(), target);
    const std::size_t i =
        std::min<std::size_t>(static_cast<std::size_t>(found - this->Cumulative.begin()), this->Cumulative.size() - 1);
    const SkyOpenings::Rectangle& r = this->Openings->all()[i];
    point = r.corner + u1 * r.u + u2 * r.v;
    if (!this->draw(this->Faces[r.face], u3, u4, direction) || !(dot(direction, r.outward) > 0))
      return {};
  }
  else
  {
    if (!this->draw(this->All, u3, u4, direction))
      return {};
    const Frame across(direction);
    const double radius = this->Radius * std::sqrt(u1), turn = 2 * pi * u2;
    point = radius * std::cos(turn) * across.s + radius * std::sin(turn) * across.t;
  }
  const double density = this->density(point, direction);
  Line line;
  line.direction = -direction;
  // Far enough to be outside of the scene's sphere, whatever the point.
  line.start = point + (2 * this->Radius + length(point)) * direction;
  line.weight = density > 0 ? sky.luminanceWithSun(direction) / density : 0;
  return line;
}
}  // namespace kalos
