// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/NearestTriangle.h"

#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "mesh/ShapeTree.h"

namespace kalos::meshing
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct NearestTriangle::Impl : ShapeTree<Kernel, Kernel::Triangle_3, CGAL::AABB_triangle_primitive>
{
};

NearestTriangle::NearestTriangle(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles)
    : Tree(std::make_unique<Impl>())
{
  for (const std::uint32_t t : triangles)
  {
    const Triangle& corners = mesh.triangles[t];
    Tree->add(
        {Impl::cgal(mesh.points[corners[0]]), Impl::cgal(mesh.points[corners[1]]), Impl::cgal(mesh.points[corners[2]])},
        t);
  }
  Tree->build();
}

NearestTriangle::~NearestTriangle() = default;

std::uint32_t NearestTriangle::to(const Point& point) const
{
  return static_cast<std::uint32_t>(Tree->nearest(point).number);
}
}  // namespace kalos::meshing
