// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/SphericalRectangle.h"

namespace kalos
{
SphericalRectangle::SphericalRectangle(const Vec3& from, const Vec3& corner, const Vec3& u, const Vec3& v) : From(from)
{
  const double lengthU = length(u), lengthV = length(v);
  this->X = (1 / lengthU) * u;
  this->Y = (1 / lengthV) * v;
  this->Z = cross(this->X, this->Y);
  const Vec3 d = corner - from;
  this->Z0 = dot(d, this->Z);
  if (this->Z0 > 0)
  {
    this->Z = -this->Z;
    this->Z0 = -this->Z0;
  }
  this->X0 = dot(d, this->X);
  this->Y0 = dot(d, this->Y);
  this->X1 = this->X0 + lengthU;
  this->Y1 = this->Y0 + lengthV;

  // Normals of the planes through the point and a side, and the angles between them.
  const Vec3 c00{this->X0, this->Y0, this->Z0}, c10{this->X1, this->Y0, this->Z0}, c11{this->X1, this->Y1, this->Z0},
      c01{this->X0, this->Y1, this->Z0};
  const Vec3 n0 = normalized(cross(c00, c10)), n1 = normalized(cross(c10, c11)), n2 = normalized(cross(c11, c01)),
             n3 = normalized(cross(c01, c00));
  const auto angle = [](const Vec3& a, const Vec3& b) { return std::acos(std::clamp(-dot(a, b), -1.0, 1.0)); };
  const double g0 = angle(n0, n1), g1 = angle(n1, n2), g2 = angle(n2, n3), g3 = angle(n3, n0);
  this->B0 = n0.z;
  this->B1 = n2.z;
  this->K = 2 * pi - g2 - g3;
  this->Omega = std::max(0.0, g0 + g1 - this->K);
}

Vec3 SphericalRectangle::sample(double u1, double u2) const
{
  const double a = u1 * this->Omega + this->K;
  const double f = (std::cos(a) * this->B0 - this->B1) / std::sin(a);
  const double cu = std::clamp(std::copysign(1 / std::sqrt(f * f + this->B0 * this->B0), f), -1.0, 1.0);
  const double x = std::clamp(-(cu * this->Z0) / std::sqrt(std::max(1e-300, 1 - cu * cu)), this->X0, this->X1);
  const double d2 = x * x + this->Z0 * this->Z0;
  const double h0 = this->Y0 / std::sqrt(d2 + this->Y0 * this->Y0), h1 = this->Y1 / std::sqrt(d2 + this->Y1 * this->Y1);
  const double h = h0 + u2 * (h1 - h0), rest = 1 - h * h;
  const double y = rest > 1e-15 ? std::clamp(h * std::sqrt(d2 / rest), this->Y0, this->Y1) : this->Y1;
  return this->From + x * this->X + y * this->Y + this->Z0 * this->Z;
}
}  // namespace kalos
