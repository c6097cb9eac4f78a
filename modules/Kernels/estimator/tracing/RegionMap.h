// SPDX-License-Identifier: BSD-3-Clause
// Which regions of a scene trajectories reach, and which the receivers: from the points of a pilot's paths.
#ifndef kalos_estimator_tracing_RegionMap_h
#define kalos_estimator_tracing_RegionMap_h

#include <cmath>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
/// 0 to 5: the axis that a normal is most along, and its sign.
inline int mainDirection(const Vec3& n)
{
  const int axis =
      std::abs(n.x) > std::abs(n.y) ? (std::abs(n.x) > std::abs(n.z) ? 0 : 2) : (std::abs(n.y) > std::abs(n.z) ? 1 : 2);
  const double along = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
  return 2 * axis + (along > 0);
}

/// Six k-d trees over surface points, one for each main direction of the normal, so that the two sides of a thin wall
/// never share a leaf. Each leaf is a region.
class RegionMap
{
public:
  struct Point
  {
    Vec3 position, normal;
    bool fromReceivers;  ///< met by a path from a receiver, else by a trajectory
  };
  struct Region
  {
    double contrast = 0;      ///< log of (points from receivers / points of light), each over its total
    std::vector<Point> some;  ///< of its points, of both kinds where there are
  };

  RegionMap() = default;
  RegionMap(std::vector<Point> points, std::ptrdiff_t largestRegion);

  static constexpr int none = -1;
  /// Index of the region about a point of a surface, or of a plane in space with the normal n; or none.
  int find(const Vec3& p, const Vec3& n) const;
  const std::vector<Region>& regions() const { return this->Regions; }
  double contrast(const Vec3& p, const Vec3& n) const;  ///< 0 where there is no region

private:
  struct Node
  {
    int axis = none;        // none: a leaf
    int low = 0, high = 0;  // children; of a leaf: the region, twice
    double at = 0;
  };
  using Points = std::vector<Point>;
  int build(Points::iterator begin, Points::iterator end, double perLight);

  std::ptrdiff_t Largest = 1;
  std::vector<Node> Nodes;
  std::vector<Region> Regions;
  int Roots[6] = {none, none, none, none, none, none};
};
}  // namespace kalos

#endif
