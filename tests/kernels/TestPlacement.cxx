// SPDX-License-Identifier: BSD-3-Clause
// Receivers on edges and nearer to them than single precision can tell.
#include <gtest/gtest.h>

#include "Poses.h"
#include "sampling/Warp.h"
#include "scene/Placement.h"

using namespace poses;

// From a nanometre to a micrometre off the walls of a closed room, in a corner and along an edge, every ray meets one.
TEST(Placement, NoRayGetsOutBesideAnEdge)
{
  for (std::uint64_t turn = 0; turn < 3; ++turn)
  {
    Pose pose;
    if (turn > 0)
      pose.axes = randomAxes(turn);
    const Scene scene(posed(rooms::litRoom(0.6), pose));
    RandomStream random(turn, 0, Purpose::Gather, 0);
    int lost = 0;
    for (const double h : {1e-9, 1e-8, 1e-7, 1e-6})
      for (const Vec3& p : {Vec3{h, h, 0}, Vec3{h, 2, 0}, Vec3{5 - h, 3, 0}})
      {
        const RayAnchor anchor = placeReceiver(scene, pose(p) - scene.origin(), pose.turned({0, 0, 1}));
        for (int i = 0; i < 2000; ++i)
        {
          const double u1 = random.next(), u2 = random.next();
          lost += !scene.trace(anchor, Frame(anchor.normal).toWorld(cosineHemisphere(u1, u2))).valid;
        }
      }
    EXPECT_LE(lost, 2) << "of 24000, turn " << turn;
  }
}

// On a wall beside the floor: a receiver that lies above it by half the rounding of its coordinates stays where it is,
// one by a hundredth of it is moved off the floor, and one that is below by twice the rounding stays below.
TEST(Placement, OnlyWhatIsInDoubtIsMoved)
{
  SceneDescription d = rooms::litRoom(0.6);
  rooms::translate(d, {2.5, 2.5, 2.5});  // the floor at 2.5 m, and as far from the centre
  const Scene scene(d);
  const double rounding = 2.5 * 0x1.0p-23;
  for (const double share : {0.5, 0.01, -2.0})
  {
    const Vec3 p = Vec3{2.5, 5, 2.5 + share * rounding} - scene.origin();
    const double moved = placeReceiver(scene, p, {1, 0, 0}).point.z - p.z;
    EXPECT_TRUE(share == 0.01 ? moved > rounding : moved == 0) << share << ": " << moved;
  }
}

// On the side of a box, on its foot and in the corner of a room, from a nanometre to a millimetre off the floor:
// everywhere 250 lx, in any pose. 7 degrees of freedom, 96 values: 12 standard errors raise a false alarm of 7e-4.
TEST(Placement, FurnaceAtTheFoot)
{
  for (std::uint64_t turn = 0; turn < 3; ++turn)
    for (const Method method : {Method::Compensated, Method::Gathered})
    {
      Pose pose;
      if (turn > 0)
        pose.axes = randomAxes(turn);
      pose.shift = turn == 2 ? Vec3{1000, -2000, 500} : Vec3{};
      Receivers r;
      for (const double h : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.0})
      {
        r.points.insert(r.points.end(), {{1, 1.5, h}, {1.5, 1 - h, 0}, {h, h, 0}, {5, 5 - h, 5 - h}});
        r.normals.insert(r.normals.end(), {{-1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}});
      }
      Settings s;
      s.method = method;
      s.trajectories = 16384;
      s.disabled.insert(Technique::Paths);
      const Result result = solve(Scene(posed(rooms::furnace(0.6, 100), pose)), posed(r, pose), s);
      for (std::size_t i = 0; i < r.points.size(); ++i)
      {
        EXPECT_LT(std::abs(result.illuminance[i] - 250), 12 * result.standardError[i])
            << "turn " << turn << ", point " << i << ": " << result.illuminance[i];
        EXPECT_LT(result.standardError[i], 0.025 * 250) << "turn " << turn << ", point " << i;
      }
    }
}
