// SPDX-License-Identifier: BSD-3-Clause
// Values are flagged where almost all vertices are hidden and those that are not were never picked.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/solve/Solver.h"
#include "estimator/tally/IntervalDiagnostics.h"

using namespace kalos;

namespace
{
// A lit and a dark room of 5 m with a wall between them; a square hole of this side in its middle.
Scene besideALitRoom(double hole)
{
  SceneDescription d = rooms::litRoom(0.7);
  for (Vec3& p : d.points)
    p.x = 2 * p.x - 5;  // from -5 to 5 m, the lamp at 2.5 m
  const double low = 2.5 - hole / 2, high = 2.5 + hole / 2;
  rooms::addQuad(d, {0, 0, 0}, {0, low, 0}, {0, 0, 5}, 0);
  rooms::addQuad(d, {0, high, 0}, {0, low, 0}, {0, 0, 5}, 0);
  rooms::addQuad(d, {0, low, 0}, {0, hole, 0}, {0, 0, low}, 0);
  rooms::addQuad(d, {0, low, high}, {0, hole, 0}, {0, 0, low}, 0);
  return Scene(d);
}

// The share of trusted values on the floor, from x on.
double trusted(const Scene& scene, double x, Method method)
{
  Receivers r;
  for (int i = 0; i < 36; ++i)
  {
    r.points.push_back({x + 0.7 * (i % 6), 0.7 + 0.7 * (i / 6), 0});
    r.normals.push_back({0, 0, 1});
  }
  Settings s;
  s.method = method;
  s.trajectories = 4096;
  const Result result = solve(scene, r, s);
  return static_cast<double>(std::count(result.trusted.begin(), result.trusted.end(), 1)) / 36;
}
}  // namespace

TEST(HiddenLight, AFewPicksSeenDoNotSettleIt)
{
  const MeanAndError estimate{10, 0.1};
  EXPECT_TRUE(hiddenIsLittle({0, 0, 0}, 100, estimate));       // nothing was picked
  EXPECT_FALSE(hiddenIsLittle({1e5, 500, 0}, 100, estimate));  // 2 lx a pick: three of them might be missed
  EXPECT_TRUE(hiddenIsLittle({1e4, 500, 0}, 100, estimate));   // 0.6 lx at most
  EXPECT_TRUE(hiddenIsLittle({1e5, 500, 16}, 100, estimate));  // enough were seen for the replicates to know
  EXPECT_FALSE(hiddenIsLittle({1e5, 500, 15}, 100, estimate));
  EXPECT_TRUE(hiddenIsLittle({1e5, 500, 0}, 100, {10, 4}));  // within the interval
  EXPECT_TRUE(hiddenIsLittle({1e5, 500, 0}, 100, {1000, 0.1}));
}

TEST(HiddenLight, ARoomBehindAKeyholeIsFlagged)
{
  const Scene keyhole = besideALitRoom(0.02), gate = besideALitRoom(3);
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    EXPECT_LT(trusted(keyhole, -4.3, method), 0.1);
    EXPECT_GT(trusted(keyhole, 0.7, method), 0.9);  // the lit room
    EXPECT_GT(trusted(gate, -4.3, method), 0.9);
  }
}
