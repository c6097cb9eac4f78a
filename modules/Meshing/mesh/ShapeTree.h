// SPDX-License-Identifier: BSD-3-Clause
/** CGAL's tree over triangles or segments that are numbered; for sources only, as it includes CGAL. */
#ifndef KalosMeshingShapeTree_h
#define KalosMeshingShapeTree_h

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <cstddef>
#include <vector>

#include "mesh/Vector.h"

namespace kalos::meshing
{
/** `Primitive` is CGAL::AABB_triangle_primitive or CGAL::AABB_segment_primitive, `Shape` the kernel's type for it. */
template <typename Kernel, typename Shape, template <typename, typename, typename> class Primitive>
class ShapeTree
{
public:
  struct Nearest
  {
    double squaredDistance;  ///< m²
    std::size_t number;
  };

  static typename Kernel::Point_3 cgal(const Point& p) { return {p[0], p[1], p[2]}; }

  void add(const Shape& shape, std::size_t number)
  {
    Shapes.push_back(shape);
    Numbers.push_back(number);
  }

  /** After the last shape. */
  void build()
  {
    Tree.insert(Shapes.cbegin(), Shapes.cend());
    Tree.build();
  }

  bool empty() const { return Shapes.empty(); }

  Nearest nearest(const Point& point) const
  {
    const auto query = cgal(point);
    const auto found = Tree.closest_point_and_primitive(query);
    return {CGAL::to_double(CGAL::squared_distance(found.first, query)),
            Numbers[static_cast<std::size_t>(found.second - Shapes.cbegin())]};
  }

private:
  using Iterator = typename std::vector<Shape>::const_iterator;

  std::vector<Shape> Shapes;
  std::vector<std::size_t> Numbers;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive<Kernel, Iterator, CGAL::Tag_false>>> Tree;
};
}  // namespace kalos::meshing

#endif
