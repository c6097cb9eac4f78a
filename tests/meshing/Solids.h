// SPDX-License-Identifier: BSD-3-Clause
// Boxes and rooms to build test meshes from.
#ifndef kalos_tests_Solids_h
#define kalos_tests_Solids_h

#include <cmath>

#include "mesh/TriangleMesh.h"

namespace solids
{
using kalos::meshing::Point;
using kalos::meshing::TriangleMesh;

inline void addTriangle(TriangleMesh& mesh, const Point& a, const Point& b, const Point& c, std::uint32_t material = 0)
{
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Point& p : {a, b, c})
    mesh.points.push_back(p);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.origin.push_back(static_cast<std::uint32_t>(mesh.origin.size()));
  mesh.material.push_back(material);
}

/// Parallelogram of n x n x 2 triangles; the front is on the side of u x v.
inline void addQuad(TriangleMesh& mesh, const Point& origin, const Point& u, const Point& v, int n = 1,
                    std::uint32_t material = 0)
{
  const auto at = [&](int i, int j) { return origin + (double(i) / n) * u + (double(j) / n) * v; };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      addTriangle(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), material);
      addTriangle(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1), material);
    }
  }
}

/// Box from a corner along three edges, u x v on the side of w; its front is outside, or inside for a room.
inline void addBox(TriangleMesh& mesh, const Point& corner, const Point& u, const Point& v, const Point& w, bool inside,
                   int n = 1, std::uint32_t material = 0)
{
  const auto side = [&](const Point& o, const Point& a, const Point& b) {
    inside ? addQuad(mesh, o, b, a, n, material) : addQuad(mesh, o, a, b, n, material);
  };
  side(corner, v, u);
  side(corner + w, u, v);
  side(corner, u, w);
  side(corner + v, w, u);
  side(corner, w, v);
  side(corner + u, v, w);
}

/// Box of size (x, y, z) whose bottom's centre is at `base`, turned by `angle` radians about the vertical.
inline void addTurnedBox(TriangleMesh& mesh, const Point& base, const Point& size, double angle, int n = 1,
                         std::uint32_t material = 0)
{
  const Point u{size[0] * std::cos(angle), size[0] * std::sin(angle), 0};
  const Point v{-size[1] * std::sin(angle), size[1] * std::cos(angle), 0};
  addBox(mesh, base - 0.5 * (u + v), u, v, {0, 0, size[2]}, false, n, material);
}

/// The mesh turned about an axis that nothing is aligned with, and moved.
inline void moveAside(TriangleMesh& mesh, double angle, const Point& shift)
{
  using namespace kalos::meshing;
  const Point k = unit({0.3, -0.5, 0.8});
  for (Point& p : mesh.points)
    p = shift + (std::cos(angle) * p + std::sin(angle) * cross(k, p) + ((1 - std::cos(angle)) * dot(k, p)) * k);
}
}  // namespace solids

#endif
