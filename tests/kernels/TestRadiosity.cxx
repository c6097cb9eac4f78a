// SPDX-License-Identifier: BSD-3-Clause
// Finite-element radiosity: its form factors, its values, its stated error, and what it refuses.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/methods/RadiositySystem.h"
#include "estimator/solve/Replay.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
Receivers inTheRoom()
{
  Receivers r;
  r.points = {{2.5, 0.4, 0}, {0.0001, 2.5, 0}, {0.0001, 0.0001, 0}, {2.6, 1.9, 2.5}, {5, 4.2, 1.3}};
  r.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}};
  return r;
}

Settings settings(long long trajectories, bool linear = true, bool gather = false)
{
  Settings s;
  s.method = Method::Radiosity;
  s.trajectories = trajectories;
  s.own.linear = linear;
  s.own.finalGather = gather;
  return s;
}

std::string line(const Result& result, const std::string& subject)
{
  for (const AuditLine& one : result.audit)
    if (one.subject == subject)
      return one.choice + " (" + one.reason + ")";
  return {};
}

std::string refusal(const SceneDescription& room, const Settings& s)
{
  try
  {
    solve(Scene(room), inTheRoom(), s);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "accepted";
}
}  // namespace

// Every surface point of a scene lies in the element that locate() names, at the weights that it gives.
TEST(RadiosityMesh, LocatesPointsInElements)
{
  const Scene scene(rooms::litRoom(0.7));
  const LitSides sides(scene, Emission(scene), 1);
  EXPECT_EQ(sides.count(), 12u) << "the insides of six walls";
  const RadiosityMesh mesh(scene, sides, 1.3);
  EXPECT_EQ(mesh.elements().size(), RadiosityMesh::count(scene, sides, 1.3));
  RandomStream random(1, 0, Purpose::Gather, 0);
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 direction{random.next() - 0.5, random.next() - 0.5, random.next() - 0.5};
    const SurfacePoint y = scene.trace(RayAnchor({0.3, 0.2, 0.1}), normalized(direction));
    RadiosityMesh::Place place;
    ASSERT_TRUE(y.valid && mesh.locate(y, place));
    const RadiosityElement& e = mesh.elements()[place.element];
    EXPECT_EQ(e.triangle, y.triangle);
    Vec3 at{};
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_GE(place.weight[k], -1e-9);
      at += place.weight[k] * e.corner[k];
    }
    EXPECT_LT(length(at - y.position), 1e-6);
  }
}

// In a furnace E = M/(1 - rho), which elements of any length have: form factors sum to one.
TEST(Radiosity, IsExactInAFurnace)
{
  SceneDescription cube;
  rooms::addBox(cube, {0, 0, 0}, {5, 5, 5}, rooms::addMaterial(cube, 0.6, 100), true);
  for (const bool linear : {false, true})
    for (const bool gather : {false, true})
    {
      const Result result = solve(Scene(cube), inTheRoom(), settings(10000, linear, gather));
      for (const double e : result.illuminance)
        EXPECT_NEAR(e, 250, 0.1) << linear << gather;
    }
}

// Beside `compensated`, whose errors are below 0.5 %: within 4 % at surfaces, on an edge and in the air, within 12 % in
// a corner, which an element is too large for.
TEST(Radiosity, AgreesInAFurnishedRoom)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  Settings judge;
  judge.trajectories = 400000;
  const Result known = solve(scene, inTheRoom(), judge);
  for (const bool linear : {false, true})
    for (const bool gather : {false, true})
    {
      const Result result = solve(scene, inTheRoom(), settings(40000, linear, gather));
      for (std::size_t i = 0; i < known.illuminance.size(); ++i)
        EXPECT_NEAR(result.illuminance[i] / known.illuminance[i], 1, i == 2 ? 0.3 : 0.04)
            << linear << gather << " " << i;
    }
}

// Every round draws visibility anew, and each replicate has numbers of its own.
TEST(Radiosity, IsTheSameForThreadsAndWhenPlayedAgain)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  Settings s = settings(3200);
  s.keepReplicates = true;
  s.threads = 1;
  const Result one = solve(scene, inTheRoom(), s);
  s.threads = 3;
  EXPECT_EQ(one.replicateIlluminance, solve(scene, inTheRoom(), s).replicateIlluminance);
  const Replay again = replay(scene, inTheRoom(), s, 1, 2);
  EXPECT_DOUBLE_EQ(again.estimate, one.replicateIlluminance[static_cast<std::size_t>(one.replicates) + 2]);
  EXPECT_GT(one.standardError[0], 0);
  s.trajectories = 0;
  s.epsilon = 2.5;
  s.relativeError = 0.01;  // rounds go on until the noise is within it
  const Result longer = solve(scene, inTheRoom(), s);
  EXPECT_GT(longer.trajectories, defaultTrajectories);
  EXPECT_LT(2 * longer.standardError[0], 0.01 * longer.illuminance[0]);
}

TEST(Radiosity, StatesItsDiscretisationAndItsResidual)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  Settings s = settings(0, false);
  s.epsilon = 2.5;
  const Result coarse = solve(scene, inTheRoom(), s);
  EXPECT_NE(line(coarse, "elements").find("constant, 2.5 m long at most"), std::string::npos)
      << line(coarse, "elements");
  EXPECT_NE(line(coarse, "solution").find("Gauss-Seidel"), std::string::npos);
  EXPECT_NE(line(coarse, "discretisation").find("elements twice as long"), std::string::npos);
  EXPECT_EQ(coarse.trusted[1], 0) << "its element reaches far from the edge";
}

TEST(Radiosity, ComparesWithShorterElementsWhereTrianglesAreWhole)
{
  const Settings s = settings(100);
  const Result result = solve(Scene(rooms::furnishedRoom(0.5)), inTheRoom(), s);
  EXPECT_NE(line(result, "discretisation").find("elements half as long"), std::string::npos)
      << line(result, "discretisation");
}

TEST(Radiosity, RefusesWhatIsNotDiffuse)
{
  SceneDescription room = rooms::litRoom(0.5);
  room.materials[0].mirror = 0.2;
  EXPECT_EQ(refusal(room, settings(1000)),
            "method: radiosity knows diffuse surfaces only, and what is of material 0 is glossy or a mirror; expected "
            "compensated or another method");
}

TEST(Radiosity, RefusesMoreElementsThanMemoryHolds)
{
  Settings s = settings(1000);
  s.epsilon = 0.005;
  EXPECT_EQ(refusal(rooms::litRoom(0.5), s).substr(0, 66),
            "epsilon: elements of 0.005 m are 24026700, whose form factors need");
}
