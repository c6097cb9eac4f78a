// SPDX-License-Identifier: BSD-3-Clause
// Bodies of tilted faces about a point: what rounding hides first.
#ifndef kalos_tests_Bodies_h
#define kalos_tests_Bodies_h

#include "Poses.h"

namespace bodies
{
using namespace poses;

/// Rings of `columns` triangle pairs about the z axis through `centre`: a revolved profile of (radius, height), which
/// ends on the axis where the radius is 0. Normals point outwards for a profile that rises.
inline void addRevolved(SceneDescription& d, const Vec3& centre, const std::vector<std::array<double, 2>>& profile,
                        int columns, std::uint32_t material)
{
  const auto first = static_cast<std::uint32_t>(d.points.size());
  for (const auto& [radius, height] : profile)
    for (int k = 0; k < columns; ++k)
    {
      const double phi = 2 * pi * (k + 0.3) / columns;
      d.points.push_back(centre + Vec3{radius * std::cos(phi), radius * std::sin(phi), height});
    }
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
    for (int k = 0; k < columns; ++k)
    {
      auto at = [&](std::size_t i, int j) {
        return first + static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(columns) +
               static_cast<std::uint32_t>(j % columns);
      };
      if (profile[ring][0] > 0)
        d.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      if (profile[ring + 1][0] > 0)
        d.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
  d.triangleMaterial.resize(d.triangles.size(), material);
}

inline std::vector<std::array<double, 2>> ballProfile(double radius, int rings)
{
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= rings; ++i)
    profile.push_back(
        {i == 0 || i == rings ? 0 : radius * std::sin(pi * i / rings), -radius * std::cos(pi * i / rings)});
  return profile;
}

/// The n-th of `count` directions spread evenly over the sphere.
inline Vec3 spread(int n, int count)
{
  const double z = 1 - (2 * n + 1.0) / count, r = std::sqrt(1 - z * z), phi = pi * (3 - std::sqrt(5.0)) * n;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Panels that look away from `centre` in all directions, each with a slightly larger black one a millimetre behind it.
inline void addFan(SceneDescription& d, const Vec3& centre, double radius, double side, int count,
                   std::uint32_t material, std::uint32_t black)
{
  for (int i = 0; i < count; ++i)
  {
    const Vec3 n = spread(i, count);
    addPanel(d, centre + radius * n, n, side, material);
    addPanel(d, centre + (radius - 1e-3) * n, n, side + 6e-3, black);
  }
}
}  // namespace bodies

#endif
