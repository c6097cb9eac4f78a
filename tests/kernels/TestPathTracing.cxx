// SPDX-License-Identifier: BSD-3-Clause
// Path tracing finds the same light as the methods with vertices, by luminaires, emitting meshes, gloss and mirrors.
#include <gtest/gtest.h>

#include "MirrorAndGloss.h"
#include "estimator/solve/Solver.h"
#include "statistics/Replicates.h"

using namespace kalos;

namespace
{
Receivers inTheRoom()
{
  Receivers r;
  r.points = {{2.5, 0.4, 0}, {0.3, 2.5, 0}, {2.6, 1.9, 2.5}, {5, 4.2, 1.3}};
  r.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}};
  return r;
}

Result solved(const SceneDescription& room, Method method, std::uint64_t seed, long long trajectories,
              bool sampleDirect = false)
{
  Settings s;
  s.method = method;
  s.seed = seed;
  s.trajectories = trajectories;
  if (sampleDirect)
    s.disabled.insert(Technique::ExactDirect);
  return solve(Scene(room), inTheRoom(), s);
}

// Differences of 4 receivers over `seeds` seeds, within 5 standard errors of 2 (seeds - 1) degrees of freedom.
void expectTheSame(const SceneDescription& room, long long trajectories, double precision, bool sampleDirect = false)
{
  constexpr int seeds = 20;
  std::vector<double> values[2][4];
  for (int i = 0; i < seeds; ++i)
    for (const bool paths : {false, true})
    {
      const Result found =
          solved(room, paths ? Method::Paths : Method::Compensated, 10 + i, trajectories, paths && sampleDirect);
      for (int r = 0; r < 4; ++r)
        values[paths][r].push_back(found.illuminance[r]);
    }
  for (int r = 0; r < 4; ++r)
  {
    const MeanAndError a = summarise(values[1][r].data(), seeds), b = summarise(values[0][r].data(), seeds);
    const double error = std::hypot(a.standardError, b.standardError);
    EXPECT_LT(std::abs(a.mean - b.mean), 5 * error) << "receiver " << r << ": " << a.mean << ", " << b.mean;
    EXPECT_LT(error, precision * b.mean) << "receiver " << r;
  }
}

// A lamp that is a mesh, a lamp of no extent, a mirror and a glossy wall. (Nearer to a wall than the receivers stand,
// `compensated` is no judge here: light from a point by a mirror scores there in rare spikes.)
SceneDescription shinyRoom(double panel)
{
  SceneDescription room = rooms::furnishedRoom(0.5);
  rooms::addQuad(room, {1, 3, 4.9}, {0, panel, 0}, {panel, 0, 0},
                 rooms::addMaterial(room, 0.3, 1000 / (panel * panel)));
  rooms::addMirrorAndGloss(room);
  return room;
}
}  // namespace

// Three tests of 4 receivers each, 38 degrees of freedom: false alarm 1.6e-4 in all.
TEST(PathTracing, AgreesInAFurnishedRoom)
{
  expectTheSame(rooms::furnishedRoom(0.7), 1600, 0.01);
}

TEST(PathTracing, AgreesOnGlossAndMirrorsBesideASmallLuminousMesh)
{
  expectTheSame(shinyRoom(0.2), 3200, 0.02);
}

TEST(PathTracing, AgreesWhereMeshesAreSampledAtReceiversToo)
{
  expectTheSame(shinyRoom(2), 3200, 0.02, true);
}

// E = 100/(1 - rho) at every point; 16 values within 5 standard errors of 7 degrees of freedom: false alarm 0.025 in
// all for independent values, of fixed seeds.
TEST(PathTracing, IsExactInAFurnace)
{
  const Result found = solved(rooms::furnace(0.6, 100), Method::Paths, 1, 6400);
  for (int r = 0; r < 4; ++r)
  {
    EXPECT_LT(std::abs(found.illuminance[r] - 250), 5 * found.standardError[r]) << r;
    EXPECT_LT(found.standardError[r], 2) << r;
  }
}

// Next event estimation pays where the luminous mesh is small: its lamp is met by one path in a thousand. The errors
// have a spread of a quarter each; 0.25 is far from the ratio without it, which exceeds 2.
TEST(PathTracing, FindsASmallLuminousMeshByNextEventEstimation)
{
  SceneDescription room = rooms::furnishedRoom(0.5);
  room.luminaires.clear();
  rooms::addQuad(room, {2.4, 2.4, 4.9}, {0, 0.2, 0}, {0.2, 0, 0}, rooms::addMaterial(room, 0.3, 250000));
  const Result found = solved(room, Method::Paths, 3, 6400);
  for (int r = 0; r < 4; ++r)
    EXPECT_LT(found.standardError[r], 0.03 * (found.illuminance[r] - found.direct[r])) << r;
}
