// SPDX-License-Identifier: BSD-3-Clause
/** Arithmetic of points and directions. */
#ifndef KalosVectors_h
#define KalosVectors_h

#include <array>
#include <cmath>

namespace kalos::scene
{
using Vector3 = std::array<double, 3>;

inline Vector3 Add(const Vector3& a, const Vector3& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector3 Scale(double s, const Vector3& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double Norm(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}
}  // namespace kalos::scene

#endif
