// SPDX-License-Identifier: BSD-3-Clause
// A run notices when vertices do not see what their own trajectories hit next.
#include <gtest/gtest.h>

#include "Poses.h"
#include "estimator/control/Result.h"
#include "estimator/tracing/Trajectories.h"
#include "estimator/tracing/VisibilityCheck.h"

using namespace poses;

namespace
{
std::vector<AuditLine> warnings(const Scene& scene, EnergySums sums)
{
  EnergyBalance balance(scene, 1);
  balance.of(0) = std::move(sums);
  std::vector<AuditLine> found;
  for (const AuditLine& line : balance.audit())
    if (line.subject == "warning" && line.choice.find("deliver") != std::string::npos)
      found.push_back(line);
  return found;
}
}  // namespace

TEST(VisibilityCheck, FindsNothingInASoundScene)
{
  Pose pose;
  pose.axes = randomAxes(3);
  const Scene scene(posed(tiltedRoom(0.6), pose));
  LightVertices pool = traceTrajectories(scene, Emission(scene), {}, 0, 0, 40000);
  EXPECT_GT(pool.energy.checked(0), 7000);
  EXPECT_LT(pool.energy.unseen(0), 2e-4 * pool.energy.checked(0));
  EXPECT_TRUE(warnings(scene, pool.energy).empty());
}

// Vertices that were not lifted: a tilted floor hides them.
TEST(VisibilityCheck, WarnsOfVerticesThatShadowThemselves)
{
  Pose pose;
  pose.axes = randomAxes(3);
  const Scene scene(posed(rooms::litRoom(0.6), pose));
  EnergySums sums(scene.surfaces());
  sums.emitted() = sums.absorbed() = sums.trajectories() = 1;
  VisibilityCheck check(scene, sums);
  RandomStream random(1, 0, Purpose::Selection, 0);
  for (int i = 0; i < 1000; ++i)
  {
    RayAnchor from = scene.anchor(0, pose({0.5 + 4 * random.next(), 0.5 + 4 * random.next(), 0}) - scene.origin(),
                                  pose.turned({0, 0, 1}));
    from.base = from.slope = 0;
    from.point = from.point - 2e-7 * from.normal;
    const Vec3 direction = pose.turned(normalized({random.next() - 0.5, random.next() - 0.5, 1}));
    check.add(from, 0, scene.trace(scene.anchor(from.point, from.normal), direction));
  }
  check.finish();
  EXPECT_EQ(sums.checked(0), 1000);
  EXPECT_GT(sums.unseen(0), 100);
  const std::vector<AuditLine> found = warnings(scene, sums);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].choice.find("does not deliver all of its light"), std::string::npos);
  EXPECT_NE(found[0].reason.find("of 1000 vertices"), std::string::npos) << found[0].reason;
}
