// SPDX-License-Identifier: BSD-3-Clause
// Receivers that take part in what their neighbours' gather rays find.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "Rooms.h"
#include "estimator/gathering/ReceiverGroup.h"

using namespace kalos;

namespace
{
constexpr int capacity = ReceiverGroup::capacity;

Sensor at(const Scene& scene, const Vec3& p, const Vec3& n)
{
  return Sensor(placeReceiver(scene, p - scene.origin(), n));
}

// Five receivers in a row on the floor, 0.5 m apart.
ReceiverGroup row(const Scene& scene)
{
  ReceiverGroup group;
  for (int k = 0; k < 5; ++k)
    group.add(10 + static_cast<std::size_t>(k), at(scene, {1 + 0.5 * k, 2, 0}, {0, 0, 1}));
  return group;
}

// Of a receiver of that row.
double kernel(const Scene& scene, int k, const Sensor& y)
{
  const Vec3 n{0, 0, 1}, d = y.position + scene.origin() - Vec3{1 + 0.5 * k, 2, 0};
  return dot(d, n) * -dot(d, y.normal) / (dot(d, d) * dot(d, d));
}
}  // namespace

// The balance heuristic: as G goes, all together one.
TEST(ReceiverGroup, SharesGoAsTheKernel)
{
  const Scene scene(rooms::litRoom(0.5));
  const ReceiverGroup group = row(scene);
  const Sensor y = at(scene, {3, 4, 5}, {0, 0, -1});
  double kernels[5], all = 0;
  for (int k = 0; k < 5; ++k)
    all += kernels[k] = kernel(scene, k, y);
  for (const RayScene* rays : {static_cast<const RayScene*>(nullptr), &scene.rays()})
  {
    const ReceiverGroup::Shares found = group.share(y, 2, false, rays);
    for (int k = 0; k < 5; ++k)
    {
      EXPECT_NEAR(found.share[k], kernels[k] / all, 1e-6);
      EXPECT_NEAR(found.kernel[k], kernels[k] / pi, 1e-6 * kernels[k]);
    }
    for (int k = 5; k < capacity; ++k)
      EXPECT_EQ(found.share[k], 0);
  }
  EXPECT_EQ(group.receiver(3), 13u);
}

// A receiver that does not see y gets nothing and has no weight among the others.
TEST(ReceiverGroup, HiddenReceiversTakeNothing)
{
  SceneDescription d = rooms::litRoom(0.5);
  rooms::addQuad(d, {0, 0, 2}, {1.7, 0, 0}, {0, 5, 0}, 0);  // above the first three, seen from right above them
  const Scene scene(d);
  const Sensor y = at(scene, {1.2, 2, 5}, {0, 0, -1});
  ReceiverGroup::Shares found = row(scene).share(y, 4, false, &scene.rays());
  const double third = kernel(scene, 3, y), fourth = kernel(scene, 4, y);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(found.share[k] + found.kernel[k], 0) << "receiver " << k;
  EXPECT_NEAR(found.share[3], third / (third + fourth), 1e-6);
  EXPECT_NEAR(found.share[4], fourth / (third + fourth), 1e-6);
  EXPECT_GT(row(scene).share(y, 4, false, nullptr).share[0], 0);
}

// Behind a receiver's surface, on the back of y's, and near: the finder alone, or without those.
TEST(ReceiverGroup, WhatCanNotBeSharedIsTheFinders)
{
  const Scene scene(rooms::litRoom(0.5));
  ReceiverGroup group = row(scene);
  auto sum = [](const ReceiverGroup::Shares& s) { return std::accumulate(s.share, s.share + capacity, 0.0f); };
  const Sensor far = at(scene, {3, 4, 5}, {0, 0, -1});
  ReceiverGroup::Shares found = group.share(far, 1, true, &scene.rays());
  EXPECT_EQ(found.share[1], 1);
  EXPECT_NEAR(found.kernel[1], kernel(scene, 1, far) / pi, 1e-9);
  EXPECT_EQ(sum(found), 1);

  // 1 micrometre off the first receiver, which finds it by its own rays.
  const Sensor near = at(scene, {1, 2.0 + 1e-6, 1e-6}, normalized({0, -1, -1}));
  found = group.share(near, 3, false, nullptr);
  EXPECT_EQ(found.share[0], 0);
  EXPECT_GT(found.share[3], 0);
  EXPECT_NEAR(sum(found), 1, 1e-6);

  group.add(15, at(scene, {2, 2, 1}, {0, 0, -1}));
  EXPECT_EQ(group.share(far, 1, false, nullptr).share[5], 0);
  found = group.share(at(scene, {3, 4, 5}, {0, 0, 1}), 1, false, nullptr);
  EXPECT_EQ(found.share[1], 1);
  EXPECT_EQ(sum(found), 1);
}

// Sixteen that follow each other on a grid are a square of four; who looks the other way follows later.
TEST(ReceiverGroup, OrderKeepsNeighboursTogether)
{
  const Scene scene(rooms::litRoom(0.5));
  std::vector<Sensor> sensors;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (const double up : {1.0, -1.0})
        sensors.push_back(at(scene, {0.25 + 0.5 * i, 0.25 + 0.5 * j, 1}, {0, 0, up}));
  const std::vector<std::size_t> order = orderOf(sensors);
  ASSERT_EQ(order.size(), 128u);
  for (std::size_t begin = 0; begin < order.size(); begin += 16)
  {
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (std::size_t i = begin; i < begin + 16; ++i)
    {
      const Sensor& s = sensors[order[i]];
      EXPECT_EQ(s.normal.z, begin < 64 ? 1 : -1);
      low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y), 1};
      high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y), 1};
    }
    EXPECT_EQ(high.x - low.x, 1.5);
    EXPECT_EQ(high.y - low.y, 1.5);
  }
  std::vector<std::size_t> all = order;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(all[i], i);
  EXPECT_EQ(orderOf({sensors[0]}), std::vector<std::size_t>{0});
  EXPECT_TRUE(orderOf({}).empty());
}
