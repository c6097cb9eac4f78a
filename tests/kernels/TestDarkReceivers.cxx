// SPDX-License-Identifier: BSD-3-Clause
// Receivers with 0 lx are counted; those that see nothing lit give a warning.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/quantities/DarkReceivers.h"
#include "estimator/solve/Solver.h"

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

DarkReceivers find(const SceneDescription& d, const std::vector<Vec3>& points, const Vec3& normal,
                   Method method = Method::Compensated)
{
  const Scene scene(d);
  Receivers receivers;
  receivers.points = points;
  receivers.normals.assign(points.size(), normal);
  Settings settings;
  settings.method = method;
  settings.trajectories = 640;
  return findDarkReceivers(scene, receivers, solve(scene, receivers, settings));
}

std::vector<AuditLine> audit(const SceneDescription& d, const std::vector<Vec3>& points, const Vec3& normal,
                             Method method = Method::Compensated)
{
  return find(d, points, normal, method).audit;
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
      const DarkReceivers found = find(roomWithSolid(0.6), points, {0, 0, z}, method);
      EXPECT_EQ(found.valid, (std::vector<char>{1, 1, 0, 0, 0, 0, 0}));
      const auto& lines = found.audit;
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

// Meshes that shine count as light. Of many dark receivers, in two solids in turn and in a shadow, each has its own
// answer.
TEST(DarkReceivers, ManyHaveAnAnswerEach)
{
  SceneDescription d = roomWithSolid(0);
  rooms::addBox(d, {0.5, 0.5, 0}, {1, 1, 1}, 0, false);
  d.luminaires.clear();
  rooms::addQuad(d, {1, 1, 4.9}, {0, 1, 0}, {1, 0, 0}, rooms::addMaterial(d, 0, 1000));
  rooms::addQuad(d, {3.5, 3.5, 2}, {1.4, 0, 0}, {0, 1.4, 0}, 0);  // a black shelf, and a shadow below it
  std::vector<Vec3> points{{4.9, 0.1, 0.5}};
  std::vector<char> valid{1};
  for (int row = 0; row < 300; ++row)
    for (const Vec3& corner : {Vec3{2.1, 2.1, 0.5}, Vec3{0.6, 0.6, 0.5}, Vec3{4.4, 4.4, 1.9}})
      for (int i = 0; i < 10; ++i)
      {
        points.push_back(corner + Vec3{0.02 * i, 1e-3 * row, 0});
        valid.push_back(corner.z > 1);
      }
  const DarkReceivers found = find(d, points, {0, 0, 1}, Method::Local);
  EXPECT_EQ(found.valid, valid);
  ASSERT_EQ(found.audit.size(), 2u);
  EXPECT_EQ(found.audit[0].choice, "9000 of 9001");
  EXPECT_EQ(found.audit[1].choice, "receivers with nothing lit in sight: 6000");
}
