// SPDX-License-Identifier: BSD-3-Clause
// Receivers in an order that keeps neighbours together.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/SpatialOrder.h"

using namespace kalos;

// Sixteen that follow each other on a grid are a square of four; who looks the other way follows later.
TEST(SpatialOrder, KeepsNeighboursTogether)
{
  std::vector<Vec3> points, normals;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (const double up : {1.0, -1.0})
      {
        points.push_back({0.25 + 0.5 * i, 0.25 + 0.5 * j, 1});
        normals.push_back({0, 0, up});
      }
  const std::vector<std::size_t> order = spatialOrder(points, normals);
  ASSERT_EQ(order.size(), 128u);
  for (std::size_t begin = 0; begin < order.size(); begin += 16)
  {
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (std::size_t i = begin; i < begin + 16; ++i)
    {
      const Vec3& p = points[order[i]];
      EXPECT_EQ(normals[order[i]].z, begin < 64 ? 1 : -1);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 1};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), 1};
    }
    EXPECT_EQ(high.x - low.x, 1.5);
    EXPECT_EQ(high.y - low.y, 1.5);
  }
  std::vector<std::size_t> all = order;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(all[i], i);
  EXPECT_EQ(spatialOrder({points[0]}, {normals[0]}), std::vector<std::size_t>{0});
  EXPECT_TRUE(spatialOrder({}, {}).empty());
}
