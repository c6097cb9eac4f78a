// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "mesh/SortedSides.h"
#include "mesh/Tolerances.h"
#include "repair/SurfaceRepair.h"

namespace kalos::meshing
{
namespace
{
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

Box boxAround(const Point& a, const Point& b, double margin, std::uint32_t index)
{
  double low[3], high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::min(a[axis], b[axis]) - margin;
    high[axis] = std::max(a[axis], b[axis]) + margin;
  }
  return Box(low, high, index);
}

/// A point on a side of a triangle.
struct Insertion
{
  std::uint32_t triangle;
  std::uint8_t side;
  double along;  ///< from the side's first corner, m
  std::uint32_t point;
};

/// The points on the sides of border triangles, sorted by triangle, side and place.
std::vector<Insertion> findInsertions(const TriangleMesh& mesh, const Tolerances& tolerances)
{
  const std::vector<Side> sides = sortedSides(mesh);
  std::vector<Side> borders;
  std::vector<std::uint32_t> corners;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first != 1)
      return;
    borders.push_back(sides[first]);
    corners.push_back(sides[first].low);
    corners.push_back(sides[first].high);
  });
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

  std::vector<Box> edgeBoxes, pointBoxes;
  for (std::uint32_t i = 0; i < borders.size(); ++i)
    edgeBoxes.push_back(boxAround(mesh.points[borders[i].low], mesh.points[borders[i].high],
                                  tolerances.of(borders[i].low, borders[i].high), i));
  for (const std::uint32_t corner : corners)
    pointBoxes.push_back(boxAround(mesh.points[corner], mesh.points[corner], 0.0, corner));
  std::vector<Insertion> found;
  CGAL::box_intersection_d(edgeBoxes.begin(), edgeBoxes.end(), pointBoxes.begin(), pointBoxes.end(),
                           [&](const Box& edge, const Box& corner) {
                             const Side& side = borders[edge.info()];
                             const Triangle& triangle = mesh.triangles[side.triangle];
                             const std::uint32_t from = triangle[side.number], to = triangle[(side.number + 1) % 3];
                             const double distance = std::min(tolerances.of(from, to), tolerances.of(corner.info()));
                             const Point along = mesh.points[to] - mesh.points[from];
                             const Point offset = mesh.points[corner.info()] - mesh.points[from];
                             const double length = norm(along), place = dot(offset, along) / length;
                             if (std::find(triangle.begin(), triangle.end(), corner.info()) == triangle.end() &&
                                 place > distance && place < length - distance &&
                                 norm(offset - (place / length) * along) <= distance)
                               found.push_back({side.triangle, side.number, place, corner.info()});
                           });
  std::sort(found.begin(), found.end(), [](const Insertion& a, const Insertion& b) {
    if (a.triangle != b.triangle)
      return a.triangle < b.triangle;
    return a.side != b.side ? a.side < b.side : a.along < b.along;
  });
  return found;
}

using Chain = std::vector<std::uint32_t>;

/// A triangle of apex and each link of the chain.
void fan(std::uint32_t apex, const Chain& chain, std::vector<Triangle>& pieces)
{
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    pieces.push_back({apex, chain[i], chain[i + 1]});
}

/// The triangle with its sides' points, each side a chain from corner to corner; the first side has some.
std::vector<Triangle> cut(const std::array<Chain, 3>& sides)
{
  const Chain &base = sides[0], &right = sides[1], &left = sides[2];
  const std::uint32_t apex = left.front();
  std::vector<Triangle> pieces;
  fan(apex, Chain(base.begin() + 1, base.end() - 1), pieces);
  // The outermost pieces have a whole side of the triangle each, and so its points.
  fan(base[1], left, pieces);
  fan(base[base.size() - 2], right, pieces);
  return pieces;
}
}  // namespace

std::size_t splitBorders(TriangleMesh& mesh, const Tolerances& tolerances)
{
  const std::vector<Insertion> found = findInsertions(mesh, tolerances);
  std::size_t count = 0;
  for (std::size_t i = 0; i < found.size(); ++count)
  {
    const std::uint32_t t = found[i].triangle;
    const Triangle triangle = mesh.triangles[t];
    std::array<Chain, 3> sides;
    for (int k = 0; k < 3; ++k)
      sides[k].push_back(triangle[k]);
    for (; i < found.size() && found[i].triangle == t; ++i)
      sides[found[i].side].push_back(found[i].point);
    for (int k = 0; k < 3; ++k)
      sides[k].push_back(triangle[(k + 1) % 3]);
    while (sides[0].size() == 2)
      std::rotate(sides.begin(), sides.begin() + 1, sides.end());
    const std::vector<Triangle> pieces = cut(sides);
    mesh.triangles[t] = pieces.front();
    for (std::size_t p = 1; p < pieces.size(); ++p)
    {
      mesh.triangles.push_back(pieces[p]);
      mesh.origin.push_back(mesh.origin[t]);
      mesh.material.push_back(mesh.material[t]);
    }
  }
  return count;
}
}  // namespace kalos::meshing
