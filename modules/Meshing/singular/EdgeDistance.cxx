// SPDX-License-Identifier: BSD-3-Clause
#include "singular/EdgeDistance.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>

namespace kalos::meshing
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Segments = std::vector<Kernel::Segment_3>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;
using SegmentTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal(const Point& p)
{
  return {p[0], p[1], p[2]};
}
}  // namespace

struct EdgeDistance::Tree
{
  Segments segments;
  std::vector<std::size_t> curveOf;
  SegmentTree tree;
};

EdgeDistance::EdgeDistance(const Curves& curves) : tree_(std::make_unique<Tree>())
{
  for (std::size_t c = 0; c < curves.curves.size(); ++c)
  {
    const Curve& curve = curves.curves[c];
    for (std::size_t i = curve.first; i + 1 < curve.first + curve.count; ++i)
    {
      tree_->segments.emplace_back(cgal(curves.points[curves.indices[i]]), cgal(curves.points[curves.indices[i + 1]]));
      tree_->curveOf.push_back(c);
    }
  }
  tree_->tree.insert(tree_->segments.cbegin(), tree_->segments.cend());
  tree_->tree.build();
  if (!tree_->segments.empty())
    tree_->tree.accelerate_distance_queries();
}

EdgeDistance::~EdgeDistance() = default;

EdgeDistance::Nearest EdgeDistance::nearest(const Point& point) const
{
  if (tree_->segments.empty())
    return {std::numeric_limits<double>::infinity(), 0};
  const auto found = tree_->tree.closest_point_and_primitive(cgal(point));
  const double squared = CGAL::to_double(CGAL::squared_distance(found.first, cgal(point)));
  return {std::sqrt(squared), tree_->curveOf[static_cast<std::size_t>(found.second - tree_->segments.cbegin())]};
}
}  // namespace kalos::meshing
