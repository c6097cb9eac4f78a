// SPDX-License-Identifier: BSD-3-Clause
#include "singular/EdgeDistance.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>

#include "mesh/ShapeTree.h"

namespace kalos::meshing
{
using Kernel = CGAL::Simple_cartesian<double>;

struct EdgeDistance::Impl : ShapeTree<Kernel, Kernel::Segment_3, CGAL::AABB_segment_primitive>
{
};

EdgeDistance::EdgeDistance(const Curves& curves) : Tree(std::make_unique<Impl>())
{
  for (std::size_t c = 0; c < curves.curves.size(); ++c)
  {
    const Curve& curve = curves.curves[c];
    for (std::size_t i = curve.first; i + 1 < curve.first + curve.count; ++i)
      Tree->add({Impl::cgal(curves.points[curves.indices[i]]), Impl::cgal(curves.points[curves.indices[i + 1]])}, c);
  }
  Tree->build();
}

EdgeDistance::~EdgeDistance() = default;

EdgeDistance::Nearest EdgeDistance::nearest(const Point& point) const
{
  if (Tree->empty())
    return {std::numeric_limits<double>::infinity(), 0};
  const auto found = Tree->nearest(point);
  return {std::sqrt(found.squaredDistance), found.number};
}
}  // namespace kalos::meshing
