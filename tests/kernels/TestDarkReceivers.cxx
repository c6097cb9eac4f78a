// SPDX-License-Identifier: BSD-3-Clause
// Receivers with 0 lx are counted, and those that nothing lit is in sight of are a warning.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/DarkReceivers.h"
#include "estimator/Solver.h"

using namespace kalos;

namespace
{
// A closed room of 5 m, a lamp under its ceiling, a solid of 1 m in the middle of the floor.
SceneDescription roomWithSolid(double reflectance)
{
  SceneDescription d = rooms::litRoom(reflectance);
  rooms::addBox(d, {2, 2, 0}, {1, 1, 1}, 0, false);
  return d;
}

std::vector<AuditLine> audit(const SceneDescription& d, const std::vector<Vec3>& points, const Vec3& normal,
                             Method method = Method::Compensated)
{
  const Scene scene(d);
  Receivers receivers;
  receivers.points = points;
  receivers.normals.assign(points.size(), normal);
  Settings settings;
  settings.method = method;
  settings.trajectories = 640;
  return auditDarkReceivers(scene, receivers, solve(scene, receivers, settings));
}
}  // namespace

TEST(DarkReceivers, ThoseOutsideAndInSolidsAreAWarning)
{
  // Two in the light, two in the solid (one of them on its foot), one beside the room, one under its floor, one above.
  const std::vector<Vec3> points{{1, 1, 0.75},    {4, 4, 0.75},  {2.5, 2.5, 0.75}, {2.5, 2.5, 0},
                                 {-0.5, 1, 0.75}, {1, 1, -0.01}, {1, 1, 5.01}};
  for (const Method method : {Method::Local, Method::Compensated})
    for (const double z : {1.0, -1.0})
    {
      const auto lines = audit(roomWithSolid(0.6), points, {0, 0, z}, method);
      ASSERT_EQ(lines.size(), 2u);
      EXPECT_EQ(lines[0].subject, "dark receivers");
      EXPECT_EQ(lines[0].choice, "5 of 7");
      EXPECT_EQ(lines[0].reason, "0 are in full shadow or turned away from the light");
      EXPECT_EQ(lines[1].subject, "warning");
      EXPECT_EQ(lines[1].choice, "receivers with nothing lit in sight: 5");
      EXPECT_NE(lines[1].reason.find("The first is number 2 at (2.5, 2.5, 0.75)"), std::string::npos)
          << lines[1].reason;
    }
}

TEST(DarkReceivers, ShadowIsNone)
{
  // Black: what looks down under a lamp, and what a shelf shades.
  SceneDescription d = rooms::litRoom(0);
  rooms::addQuad(d, {1, 1, 2}, {3, 0, 0}, {0, 3, 0}, 0);
  const auto lines = audit(d, {{2.5, 2.5, 1}, {0.2, 0.2, 1}}, {0, 0, 1});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].choice, "1 of 2");
  EXPECT_EQ(lines[0].reason, "1 are in full shadow or turned away from the light");
  EXPECT_EQ(audit(d, {{0.2, 0.2, 1}}, {0, 0, -1}).size(), 1u);
}

TEST(DarkReceivers, NothingIsSaidWhereAllIsLitOrNothingShines)
{
  EXPECT_TRUE(audit(roomWithSolid(0.6), {{1, 1, 1}, {4, 4, 4}}, {0, 0, 1}).empty());
  SceneDescription dark = roomWithSolid(0.6);
  dark.luminaires.clear();
  EXPECT_TRUE(audit(dark, {{1, 1, 1}}, {0, 0, 1}).empty());
}

// Meshes that shine count as light; of many dark receivers some are looked at.
TEST(DarkReceivers, ManyAreThinned)
{
  SceneDescription d = roomWithSolid(0.5);
  d.luminaires.clear();
  rooms::addQuad(d, {1, 1, 4.9}, {0, 1, 0}, {1, 0, 0}, rooms::addMaterial(d, 0, 1000));
  std::vector<Vec3> points{{0.5, 0.5, 0.5}};
  for (int i = 0; i < 5000; ++i)
    points.push_back({2.5 + 1e-5 * i, 2.5, 0.5});  // in a solid
  const auto lines = audit(d, points, {0, 0, 1}, Method::Local);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].choice, "5000 of 5001");
  EXPECT_EQ(lines[1].choice, "receivers with nothing lit in sight: 4096 of the 4096 that were looked at");
}
