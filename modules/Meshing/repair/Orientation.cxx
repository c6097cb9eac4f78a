// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include "repair/SurfaceRepair.h"

namespace kalos::meshing
{
std::size_t orient(TriangleMesh& mesh, std::vector<std::uint8_t>& turned)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.points.size());
  for (const Point& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);

  // A triangle is turned by reversing its corners, so the first one tells.
  const std::size_t before = mesh.points.size();
  for (std::size_t i = before; i < points.size(); ++i)
    mesh.points.push_back({points[i].x(), points[i].y(), points[i].z()});
  turned.assign(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    turned[t] = mesh.points[triangles[t][0]] != mesh.points[mesh.triangles[t][0]];
    for (int k = 0; k < 3; ++k)
      mesh.triangles[t][k] = static_cast<std::uint32_t>(triangles[t][k]);
  }
  return points.size() - before;
}
}  // namespace kalos::meshing
