// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/NearestTriangle.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace kalos::meshing
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using TriangleTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal(const Point& p)
{
  return {p[0], p[1], p[2]};
}
}  // namespace

struct NearestTriangle::Tree
{
  Triangles triangles;
  std::vector<std::uint32_t> numbers;
  TriangleTree tree;
};

NearestTriangle::NearestTriangle(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles)
    : tree_(std::make_unique<Tree>())
{
  tree_->numbers = triangles;
  for (const std::uint32_t t : triangles)
  {
    const Triangle& corners = mesh.triangles[t];
    tree_->triangles.emplace_back(cgal(mesh.points[corners[0]]), cgal(mesh.points[corners[1]]),
                                  cgal(mesh.points[corners[2]]));
  }
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
}

NearestTriangle::~NearestTriangle() = default;

std::uint32_t NearestTriangle::to(const Point& point) const
{
  const auto found = tree_->tree.closest_point_and_primitive(cgal(point));
  return tree_->numbers[static_cast<std::size_t>(found.second - tree_->triangles.cbegin())];
}
}  // namespace kalos::meshing
