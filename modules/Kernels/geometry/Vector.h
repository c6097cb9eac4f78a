// SPDX-License-Identifier: BSD-3-Clause
// Vectors of three doubles, and orthonormal frames about a direction.
#ifndef kalos_geometry_Vector_h
#define kalos_geometry_Vector_h

#include <algorithm>
#include <cmath>

namespace kalos
{
constexpr double pi = 3.14159265358979323846;

struct Vec3
{
  double x = 0, y = 0, z = 0;

  Vec3& operator+=(const Vec3& b)
  {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(const Vec3& a)
{
  return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(double s, const Vec3& a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vec3& a, const Vec3& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Sum of |a_i b_i|: the dot product of vectors whose signs are not known.
inline double absDot(const Vec3& a, const Vec3& b)
{
  return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}
inline Vec3 cross(const Vec3& a, const Vec3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The larger of |a_i| and |b_i| on each axis.
inline Vec3 largestAbs(const Vec3& a, const Vec3& b)
{
  return {std::max(std::abs(a.x), std::abs(b.x)), std::max(std::abs(a.y), std::abs(b.y)),
          std::max(std::abs(a.z), std::abs(b.z))};
}
inline double length(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}
inline Vec3 normalized(const Vec3& a)
{
  return (1.0 / length(a)) * a;
}
inline double maxAbs(const Vec3& a)
{
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}
/// 0, 1 or 2: the axis that a vector is nearest to.
inline int mainAxis(const Vec3& a)
{
  const double largest = maxAbs(a);
  return std::abs(a.x) == largest ? 0 : std::abs(a.y) == largest ? 1 : 2;
}
inline bool isFinite(const Vec3& a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Mirror image of the direction `toward` about the unit normal n (both point away from the surface).
inline Vec3 reflected(const Vec3& toward, const Vec3& n)
{
  return 2 * dot(toward, n) * n - toward;
}

/// Right-handed orthonormal frame whose third axis is the unit vector n (Duff et al. 2017).
struct Frame
{
  Vec3 s, t, n;

  explicit Frame(const Vec3& normal) : n(normal)
  {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    s = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
  }

  Vec3 toWorld(const Vec3& v) const { return v.x * s + v.y * t + v.z * n; }
  Vec3 toLocal(const Vec3& v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
};
}  // namespace kalos

#endif
