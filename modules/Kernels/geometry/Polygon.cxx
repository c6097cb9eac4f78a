// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/Polygon.h"

#include <limits>

namespace kalos
{
namespace
{
// Sums angle times unit edge normal over the closed chain of points that it is given, seen from the origin.
class EdgeSum
{
public:
  explicit EdgeSum(const Vec3& normal) : Normal(normal) {}

  void add(const Vec3& corner)
  {
    if (this->Count++ == 0)
      this->First = corner;
    else
      this->addEdge(this->Last, corner);
    this->Last = corner;
  }

  double close()
  {
    if (this->Count < 3)
      return 0;
    this->addEdge(this->Last, this->First);
    return this->Sum;
  }

private:
  void addEdge(const Vec3& a, const Vec3& b)
  {
    const Vec3 edgeNormal = cross(a, b);
    const double sine = length(edgeNormal);
    if (sine > 0)  // an edge that points at the origin subtends no angle
      this->Sum += std::atan2(sine, dot(a, b)) * dot(this->Normal, edgeNormal) / sine;
  }

  Vec3 Normal, First, Last;
  int Count = 0;
  double Sum = 0;
};
}  // namespace

double polygonFormFactor(const Vec3& r, const Vec3& n, const Vec3* corners, int count)
{
  // Sutherland-Hodgman against the horizon, edge by edge.
  EdgeSum sum(n);
  Vec3 a = corners[count - 1] - r;
  double ha = dot(a, n);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 b = corners[i] - r;
    const double hb = dot(b, n);
    if ((ha < 0) != (hb < 0))
      sum.add(a + (ha / (ha - hb)) * (b - a));
    if (hb >= 0)
      sum.add(b);
    a = b;
    ha = hb;
  }
  return std::min(1.0, std::abs(sum.close()) / (2 * pi));
}

Vec3 nearestPoint(const Vec3* corners, int count, const Vec3& p)
{
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const Vec3 foot = p - dot(p - corners[0], normal) * normal;
  bool inside = true;
  Vec3 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i)
  {
    const Vec3 &a = corners[i], along = corners[(i + 1) % count] - a;
    inside = inside && dot(cross(along, foot - a), normal) >= 0;
    const Vec3 q = a + std::clamp(dot(foot - a, along) / dot(along, along), 0.0, 1.0) * along;
    const double squared = dot(foot - q, foot - q);
    if (squared < least)
    {
      least = squared;
      nearest = q;
    }
  }
  return inside ? foot : nearest;
}

SphericalTriangle::SphericalTriangle(const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ra = a - from, rb = b - from, rc = c - from;
  const double la = length(ra), lb = length(rb), lc = length(rc);
  if (!(la > 0 && lb > 0 && lc > 0))
    return;
  this->A = (1 / la) * ra;
  this->B = (1 / lb) * rb;
  this->C = (1 / lc) * rc;

  // Van Oosterom and Strackee: accurate also for small solid angles.
  const double triple = std::abs(dot(this->A, cross(this->B, this->C)));
  const double sum = 1 + dot(this->A, this->B) + dot(this->B, this->C) + dot(this->C, this->A);
  this->Omega = 2 * std::atan2(triple, sum);

  // Angle at A between the great circles A-B and A-C.
  const Vec3 nab = cross(this->A, this->B), nac = cross(this->A, this->C);
  this->Alpha = std::atan2(length(cross(nab, nac)), dot(nab, nac));
  this->CosAlpha = std::cos(this->Alpha);
  this->SinAlpha = std::sin(this->Alpha);
  this->CosC = dot(this->A, this->B);
  if (!(this->SinAlpha > 0))
    this->Omega = 0;
}

Vec3 SphericalTriangle::sample(double u1, double u2) const
{
  // Cut the triangle by a great circle through B into a part of solid angle u1 Omega.
  const double area = u1 * this->Omega;
  const double s = std::sin(area - this->Alpha), t = std::cos(area - this->Alpha);
  const double u = t - this->CosAlpha, v = s + this->SinAlpha * this->CosC;
  const double denominator = (v * s + u * t) * this->SinAlpha;
  double q = denominator != 0 ? ((v * t - u * s) * this->CosAlpha - v) / denominator : 1.0;
  q = std::clamp(q, -1.0, 1.0);

  // The corner of that part on the side A-C, then a point on the arc from B to it.
  auto orthogonal = [](const Vec3& x, const Vec3& y) {
    const Vec3 w = x - dot(x, y) * y;
    const double l = length(w);
    return l > 0 ? (1 / l) * w : Vec3{};
  };
  const Vec3 cut = q * this->A + std::sqrt(1 - q * q) * orthogonal(this->C, this->A);
  const double z = 1 - u2 * (1 - dot(cut, this->B));
  return normalized(z * this->B + std::sqrt(std::max(0.0, 1 - z * z)) * orthogonal(cut, this->B));
}
}  // namespace kalos
