// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/direct/LuminousArea.h"

#include <array>

#include "geometry/Polygon.h"

namespace kalos
{
namespace
{
// Triangles whose solid angles, seen from a point, make up an area's.
struct Parts
{
  std::array<SphericalTriangle, 4> triangle;
  int count = 0;

  void add(const SphericalTriangle& t) { this->triangle[static_cast<std::size_t>(this->count++)] = t; }
  const SphericalTriangle* begin() const { return this->triangle.data(); }
  const SphericalTriangle* end() const { return this->triangle.data() + this->count; }

  double solidAngle() const
  {
    double sum = 0;
    for (const SphericalTriangle& part : *this)
      sum += part.solidAngle();
    return sum;
  }
};

// A rectangle is two triangles. From a point close above it, which sees nearly a hemisphere of it, these degenerate:
// there it is a fan about the point's foot.
Parts partsOf(const LuminousArea& area, const Vec3& from)
{
  constexpr double close = 1e-3;  // of the longest side
  const Vec3* c = area.corner;
  const double height = dot(from - c[0], area.normal);
  const double longest = std::max(dot(c[1] - c[0], c[1] - c[0]), dot(c[2] - c[1], c[2] - c[1]));
  Parts parts;
  if (height * height > close * close * longest)
  {
    for (int i = 2; i < area.count; ++i)
      parts.add({from, c[0], c[i - 1], c[i]});
    return parts;
  }
  const Vec3 foot = nearestPoint(c, area.count, from);
  for (int i = 0; i < area.count; ++i)
  {
    const Vec3 &a = c[i], &b = c[(i + 1) % area.count], n = cross(b - a, foot - a);
    if (dot(n, n) > 1e-28 * longest * longest)  // the foot does not lie on this side
      parts.add({from, foot, a, b});
  }
  return parts;
}
}  // namespace

RayAnchor LuminousArea::anchorAt(const Vec3& p, bool behind) const
{
  return {p, behind ? -this->normal : this->normal, this->anchor.base, this->anchor.slope};
}

Bands LuminousArea::exitanceTowards(const Vec3& fromSensor) const
{
  if (!this->opening)
    return this->exitance;
  const double projected =
      length(cross(this->opening->sideU, this->opening->sideV)) * std::abs(dot(fromSensor, this->normal));
  return uniformBands(pi * intensity(*this->opening, -fromSensor) / projected);
}

double LuminousArea::solidAngle(const Vec3& from) const
{
  return partsOf(*this, from).solidAngle();
}

bool LuminousArea::meets(const Vec3& origin, const Vec3& direction, double& distance) const
{
  const double facing = -dot(direction, this->normal);
  const bool behind = this->isTwoSided() && facing < 0;
  if (!(facing > 0 || behind))
    return false;
  distance = dot(origin - this->corner[0], this->normal) / facing;
  if (!(distance > 0))
    return false;
  const Vec3 p = origin + distance * direction;
  // The corners turn about the normal or against it: to the left of all sides, or to the right of all.
  int left = 0;
  for (int i = 0; i < this->count; ++i)
    left += dot(cross(this->corner[(i + 1) % this->count] - this->corner[i], p - this->corner[i]), this->normal) >= 0;
  return left == 0 || left == this->count;
}

bool LuminousArea::isAfar(const Vec3& p) const
{
  constexpr double afar = 4;  // times the larger of two sides: what a point of the area sends differs by a tenth
  const Vec3 u = this->corner[1] - this->corner[0], v = this->corner[this->count - 1] - this->corner[0];
  const Vec3 d = p - 0.5 * (this->corner[1] + this->corner[this->count - 1]);
  return dot(d, d) > afar * afar * std::max(dot(u, u), dot(v, v));
}

bool LuminousArea::samplePoint(const Sensor& sensor, double u1, double u2, AreaSample& sample) const
{
  const Vec3 u = this->corner[1] - this->corner[0], v = this->corner[this->count - 1] - this->corner[0];
  const bool outside = this->count == 3 && u1 + u2 > 1;  // of a triangle: the other half of the parallelogram
  const Vec3 point = this->corner[0] + (outside ? 1 - u1 : u1) * u + (outside ? 1 - u2 : u2) * v;
  const Vec3 d = point - sensor.position;
  const double d2 = dot(d, d), cosine = dot(d, sensor.normal), facing = -dot(d, this->normal);  // times |d|
  const bool behind = this->isTwoSided() && facing < 0;
  if (!(cosine > 0) || !(facing > 0 || behind))
    return false;
  const double size = (this->count == 3 ? 0.5 : 1) * length(cross(u, v)), distance = std::sqrt(d2);
  sample.solidAngle = size * std::abs(facing) / (d2 * distance);
  sample.direction = (1 / distance) * d;
  sample.target = this->anchorAt(point, behind);
  return true;
}

bool LuminousArea::sample(const Sensor& sensor, double u1, double u2, double u3, AreaSample& sample) const
{
  const Vec3& r = sensor.position;
  if (!sensor.brdf && this->isAfar(r))
    return this->samplePoint(sensor, u2, u3, sample);
  const Parts parts = partsOf(*this, r);
  sample.solidAngle = parts.solidAngle();
  if (!(sample.solidAngle > 0))
    return false;
  const SphericalTriangle* part = parts.begin();
  for (double left = u1 * sample.solidAngle; left >= part->solidAngle() && part + 1 != parts.end(); ++part)
    left -= part->solidAngle();
  sample.direction = part->sample(u2, u3);
  const double cosine = dot(sample.direction, sensor.normal), facing = -dot(sample.direction, this->normal);
  const bool behind = this->isTwoSided() && facing < 0;
  if (!(cosine > 0) || !(facing > 0 || behind))
    return false;
  const double distance = dot(this->corner[0] - r, this->normal) / -facing;
  sample.target = this->anchorAt(r + distance * sample.direction, behind);
  return true;
}
}  // namespace kalos
