// SPDX-License-Identifier: BSD-3-Clause
// Values of final gathering beside a lamp that is near a surface are flagged until gather rays have seen the bright
// spot.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/solve/Solver.h"
#include "estimator/tally/HotSpots.h"

using namespace kalos;

namespace
{
Scene roomWithLamp(double below)
{
  SceneDescription d = rooms::litRoom(0.7);
  d.luminaires[0].position.z = 5 - below;
  d.luminaires[0].distribution = Distribution::Isotropic;
  return Scene(d);
}

double trusted(double below, Method method, long long trajectories)
{
  Receivers r;
  for (int i = 0; i < 40; ++i)
  {
    r.points.push_back({0.3 + 0.11 * i, 4.7 - 0.1 * i, 0});
    r.normals.push_back({0, 0, 1});
  }
  Settings s;
  s.method = method;
  s.trajectories = trajectories;
  const Result result = solve(roomWithLamp(below), r, s);
  double sum = 0;
  for (const char t : result.trusted)
    sum += t;
  return sum / static_cast<double>(r.points.size());
}
}  // namespace

TEST(HotSpots, ALampAtTheCeilingIsFlaggedUntilItsSpotIsSeen)
{
  EXPECT_EQ(trusted(0.01, Method::Gathered, 4096), 0);
  EXPECT_LT(trusted(0.1, Method::Gathered, 4096), 0.2);
  EXPECT_GT(trusted(2.5, Method::Gathered, 4096), 0.95);
  EXPECT_GT(trusted(0.01, Method::Compensated, 4096), 0.9);  // its vertices lie in the spot
}

// The expected number of rays in a spot grows with the rays, and direct light makes what is missed matter less.
TEST(HotSpots, RaysAndDirectLightSettleIt)
{
  const Scene scene = roomWithLamp(0.1);
  const HotSpots spots(scene, 1);
  const Sensor sensor(placeReceiver(scene, Vec3{2, 2, 0} - scene.origin(), {0, 0, 1}));
  EXPECT_FALSE(spots.areSeen(sensor, 1e3, 0));
  EXPECT_TRUE(spots.areSeen(sensor, 1e7, 0));
  EXPECT_TRUE(spots.areSeen(sensor, 1e3, 1e6));
}
