// SPDX-License-Identifier: BSD-3-Clause
// Paths alone are chosen where they are better, and find the same light as vertices: on gloss and by mirrors, too.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Replay.h"
#include "estimator/solve/Solver.h"
#include "statistics/Replicates.h"

using namespace kalos;

namespace
{
Receivers inTheRoom()
{
  Receivers r;
  r.points = {{2.5, 0.4, 0}, {0.001, 2.5, 0}, {2.6, 1.9, 2.5}, {5, 4.2, 1.3}};
  r.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}};
  return r;
}

Settings settings(Method method, std::uint64_t seed)
{
  Settings s;
  s.method = method;
  s.seed = seed;
  s.trajectories = 3200;
  return s;
}

bool byPaths(const SceneDescription& room, const Settings& s)
{
  const Scene scene(room);
  const Result result = solve(scene, inTheRoom(), s);
  return std::any_of(result.audit.begin(), result.audit.end(),
                     [](const AuditLine& line) { return line.subject == "vertices" && line.choice == "none"; });
}

// All of it luminous, with a lamp, a mirror and a glossy wall.
SceneDescription shinyRoom()
{
  SceneDescription room = rooms::furnace(0.4, 100);
  room.luminaires = rooms::litRoom(0.4, 500).luminaires;
  Material mirror, gloss;
  mirror.mirror = 0.8;
  gloss.reflectance = uniformBands(0.2);
  gloss.specular = 0.5;
  gloss.roughness = 0.2;
  gloss.exitance = uniformBands(50);
  room.materials.push_back(mirror);
  rooms::addQuad(room, {0.5, 0.02, 0.5}, {0, 0, 2}, {2, 0, 0}, 1);
  room.materials.push_back(gloss);
  rooms::addQuad(room, {4.98, 0.5, 0.5}, {0, 0, 3}, {0, 3, 0}, 2);
  return room;
}
}  // namespace

TEST(StrategyTrial, ChoosesPathsWhereLuminousSurfacesAreAllAround)
{
  for (const Method method : {Method::Compensated, Method::Gathered})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      for (const double reflectance : {0.3, 0.9})
        EXPECT_TRUE(byPaths(rooms::furnace(reflectance, 100), settings(method, seed))) << seed << " " << reflectance;
}

TEST(StrategyTrial, KeepsVerticesWhereTheySpreadTheLight)
{
  SceneDescription ceiling = rooms::furnace(0.7, 0);
  rooms::addQuad(ceiling, {0, 0, 4.99}, {0, 5, 0}, {5, 0, 0}, rooms::addMaterial(ceiling, 0.7, 100));
  for (const Method method : {Method::Compensated, Method::Gathered})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      EXPECT_FALSE(byPaths(ceiling, settings(method, seed))) << seed;
      EXPECT_FALSE(byPaths(rooms::litRoom(0.7), settings(method, seed))) << seed;
      Settings asked = settings(method, seed);
      asked.disabled.insert(Technique::Paths);
      EXPECT_FALSE(byPaths(rooms::furnace(0.5, 100), asked)) << seed;
    }
}

// Differences of 4 receivers and 2 methods over 24 seeds, within 4.5 standard errors of 46 degrees of freedom: false
// alarm 4e-4 in all.
TEST(StrategyTrial, FindsAllLightByGlossAndMirrorsToo)
{
  const SceneDescription room = shinyRoom();
  ASSERT_TRUE(byPaths(room, settings(Method::Compensated, 1))) << "nothing is compared";
  const Scene scene(room);
  constexpr int seeds = 24;
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    std::vector<double> values[2][4];
    for (int vertices = 0; vertices < 2; ++vertices)
      for (int i = 0; i < seeds; ++i)
      {
        Settings s = settings(vertices ? Method::Compensated : method, 100 + i + vertices * seeds);
        if (vertices != 0)
          s.disabled = {Technique::Paths};
        const Result result = solve(scene, inTheRoom(), s);
        for (int r = 0; r < 4; ++r)
          values[vertices][r].push_back(result.illuminance[r]);
      }
    for (int r = 0; r < 4; ++r)
    {
      const MeanAndError a = summarise(values[0][r].data(), seeds), b = summarise(values[1][r].data(), seeds);
      const double error = std::hypot(a.standardError, b.standardError);
      EXPECT_LT(std::abs(a.mean - b.mean), 4.5 * error) << "receiver " << r;
      EXPECT_LT(error, 0.015 * b.mean) << "receiver " << r;
    }
  }
}

TEST(StrategyTrial, IsTheSameForEveryNumberOfThreads)
{
  const Scene scene(rooms::furnace(0.5, 100));
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    Settings s = settings(method, 3);
    s.threads = 1;
    const Result one = solve(scene, inTheRoom(), s);
    s.threads = 3;
    EXPECT_EQ(one.illuminance, solve(scene, inTheRoom(), s).illuminance);
    s.trajectories = 3200 / one.replicates * one.replicates;
    const Replay played = replay(scene, inTheRoom(), s, 1, 2);
    s.keepReplicates = true;
    EXPECT_DOUBLE_EQ(played.estimate, solve(scene, inTheRoom(), s).replicateIlluminance[one.replicates + 2]);
  }
}
