// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/Triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>

namespace kalos::meshing
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Flat = Kernel::Point_2;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/** Twice the vector area. */
Point normalOf(const std::vector<Point>& corners)
{
  Point normal{0.0, 0.0, 0.0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return normal;
}

/** Projects along the axis nearest to the normal: the outline stays counter-clockwise and coordinates stay exact. */
std::vector<Flat> flatten(const std::vector<Point>& corners)
{
  const Point normal = normalOf(corners);
  int axis = std::abs(normal[1]) > std::abs(normal[0]) ? 1 : 0;
  axis = std::abs(normal[2]) > std::abs(normal[axis]) ? 2 : axis;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0.0)
  {
    std::swap(u, v);
  }
  std::vector<Flat> flat;
  for (const Point& corner : corners)
  {
    flat.emplace_back(corner[u], corner[v]);
  }
  return flat;
}

/** Even-odd rule: counts the edges to the right of the point. */
bool isInside(const std::vector<Flat>& outline, double x, double y)
{
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Flat& a = outline[i];
    const Flat& b = outline[(i + 1) % outline.size()];
    if ((a.y() > y) != (b.y() > y) && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
    {
      inside = !inside;
    }
  }
  return inside;
}
}  // namespace

bool isConvex(const std::vector<Point>& corners)
{
  const Point normal = normalOf(corners);
  const std::size_t size = corners.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point in = corners[i] - corners[(i + size - 1) % size];
    const Point out = corners[(i + 1) % size] - corners[i];
    if (dot(cross(in, out), normal) < 0.0)
    {
      return false;
    }
  }
  return true;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const std::vector<Point>& corners)
{
  const std::vector<Flat> flat = flatten(corners);
  Delaunay cut;
  try
  {
    std::vector<Delaunay::Vertex_handle> handles;
    for (std::uint32_t i = 0; i < flat.size(); ++i)
    {
      const std::size_t before = cut.number_of_vertices();
      handles.push_back(cut.insert(flat[i]));
      if (cut.number_of_vertices() > before)
      {
        handles.back()->info() = i;
      }
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
    {
      const auto next = handles[(i + 1) % handles.size()];
      if (handles[i] != next)
      {
        cut.insert_constraint(handles[i], next);
      }
    }
  }
  catch (const Delaunay::Intersection_of_constraints_exception&)
  {
    return {};
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto face : cut.finite_face_handles())
  {
    const Flat& a = face->vertex(0)->point();
    const Flat& b = face->vertex(1)->point();
    const Flat& c = face->vertex(2)->point();
    if (isInside(flat, (a.x() + b.x() + c.x()) / 3.0, (a.y() + b.y() + c.y()) / 3.0))
    {
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
  }
  return triangles;
}
}  // namespace kalos::meshing
