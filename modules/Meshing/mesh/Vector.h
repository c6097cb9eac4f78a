// SPDX-License-Identifier: BSD-3-Clause
/** Points and vectors of meshes, m. */
#ifndef KalosMeshingVector_h
#define KalosMeshingVector_h

#include <array>
#include <cmath>

namespace kalos::meshing
{
/** A type of its own, so that argument-dependent lookup finds the operators below. */
struct Point : std::array<double, 3>
{
};

inline Point operator+(const Point& a, const Point& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Point operator-(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Point operator*(double s, const Point& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Point& a)
{
  return std::sqrt(dot(a, a));
}

/** The vector over its length; zero stays zero. */
inline Point unit(const Point& a)
{
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}
}  // namespace kalos::meshing

#endif
