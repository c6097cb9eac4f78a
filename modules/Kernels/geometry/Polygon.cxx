// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/Polygon.h"

namespace kalos
{
namespace
{
// Sutherland-Hodgman against the plane through r with normal n; corners relative to r. Returns the new count.
int clipBelowHorizon(const Vec3& n, const Vec3* corners, int count, Vec3* clipped)
{
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % count];
    const double ha = dot(a, n), hb = dot(b, n);
    if (ha >= 0)
      clipped[kept++] = a;
    if ((ha < 0) != (hb < 0))
      clipped[kept++] = a + (ha / (ha - hb)) * (b - a);
  }
  return kept;
}
}  // namespace

double polygonFormFactor(const Vec3& r, const Vec3& n, const Vec3* corners, int count)
{
  Vec3 relative[maxPolygonCorners], clipped[maxPolygonCorners + 1];
  for (int i = 0; i < count; ++i)
    relative[i] = corners[i] - r;
  const int kept = clipBelowHorizon(n, relative, count, clipped);
  if (kept < 3)
    return 0;

  // Sum the edge vectors: angle times the normal of the plane through the edge and r.
  double sum = 0;
  for (int i = 0; i < kept; ++i)
  {
    const Vec3& a = clipped[i];
    const Vec3& b = clipped[(i + 1) % kept];
    const Vec3 edgeNormal = cross(a, b);
    const double sine = length(edgeNormal);
    if (sine > 0)  // an edge that points at r subtends no angle
      sum += std::atan2(sine, dot(a, b)) * dot(n, edgeNormal) / sine;
  }
  return std::min(1.0, std::abs(sum) / (2 * pi));
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
  auto orthogonal = [](const Vec3& x, const Vec3& y)
  {
    const Vec3 w = x - dot(x, y) * y;
    const double l = length(w);
    return l > 0 ? (1 / l) * w : Vec3{};
  };
  const Vec3 cut = q * this->A + std::sqrt(1 - q * q) * orthogonal(this->C, this->A);
  const double z = 1 - u2 * (1 - dot(cut, this->B));
  return normalized(z * this->B + std::sqrt(std::max(0.0, 1 - z * z)) * orthogonal(cut, this->B));
}
}  // namespace kalos
