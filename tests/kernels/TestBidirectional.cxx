// SPDX-License-Identifier: BSD-3-Clause
// Bidirectional path tracing: the ways to join two halves share every path, and each column alone finds all light.
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

// The values of 4 receivers over 16 seeds, within 5 standard errors of 30 degrees of freedom.
void expectTheSame(const SceneDescription& room, int connections, long long trajectories, double precision,
                   bool sampled = false)
{
  constexpr int seeds = 16;
  const Scene scene(room);
  std::vector<double> values[2][4];
  for (int i = 0; i < seeds; ++i)
    for (const bool joined : {false, true})
    {
      Settings s;
      s.method = joined ? Method::Bidirectional : Method::Paths;
      s.own.connections = connections;
      s.seed = 10 + static_cast<std::uint64_t>(i);
      s.trajectories = joined ? trajectories : 6400;
      if (sampled)
        s.disabled.insert(Technique::ExactDirect);
      const Result found = solve(scene, inTheRoom(), s);
      for (int r = 0; r < 4; ++r)
        values[joined][r].push_back(found.illuminance[r]);
    }
  for (int r = 0; r < 4; ++r)
  {
    const MeanAndError a = summarise(values[1][r].data(), seeds), b = summarise(values[0][r].data(), seeds);
    const double error = std::hypot(a.standardError, b.standardError);
    EXPECT_LT(std::abs(a.mean - b.mean), 5 * error) << connections << " " << r << ": " << a.mean << ", " << b.mean;
    EXPECT_LT(error, precision * b.mean) << connections << " " << r;
  }
}

SceneDescription shinyRoom()
{
  SceneDescription room = rooms::furnishedRoom(0.5);
  rooms::addQuad(room, {1, 3, 4.9}, {0, 1, 0}, {1, 0, 0}, rooms::addMaterial(room, 0.3, 1000));
  Luminaire panel;
  panel.position = {4, 1, 4.5};
  panel.axis = {0, 0, -1};
  panel.sideU = {0.5, 0, 0};
  panel.sideV = {0, 0.5, 0};
  panel.flux = 2000;
  room.luminaires.push_back(panel);
  rooms::addMirrorAndGloss(room);
  return room;
}
}  // namespace

// 20 values: false alarm 5e-4 in all.
TEST(Bidirectional, EachColumnAndAllTogetherFindTheSameLight)
{
  for (const int connections : {0, 1, 2, 3, 5})
    expectTheSame(rooms::furnishedRoom(0.7), connections, 1600, 0.02);
}

// Lamps of a point, a mesh and a rectangle, a mirror and a glossy wall. 12 values.
TEST(Bidirectional, AgreesOnGlossAndMirrors)
{
  for (const int connections : {0, 1, 3})
    expectTheSame(shinyRoom(), connections, 1600, 0.03);
}

TEST(Bidirectional, AgreesWhereMeshesAreSampledAtReceiversToo)
{
  expectTheSame(shinyRoom(), 0, 1600, 0.03, true);
}

// E = 250 at an edge, too, where local estimates alone are off by the spikes that they miss or hit: within 6 standard
// errors of 7 degrees of freedom, 3 values: false alarm 2e-3, of a fixed seed.
TEST(Bidirectional, IsBoundedAtAnEdge)
{
  const Scene scene(rooms::furnace(0.6, 100));
  Receivers r;
  r.points = {{1e-4, 2.5, 0}, {1e-4, 1e-4, 0}, {2.5, 2.5, 0}};
  r.normals.assign(3, {0, 0, 1});
  Settings s;
  s.method = Method::Bidirectional;
  s.trajectories = 3200;
  const Result all = solve(scene, r, s);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_LT(std::abs(all.illuminance[i] - 250), 6 * all.standardError[i]) << i;
    EXPECT_LT(all.standardError[i], 5) << i;
  }
  s.own.connections = 1;
  EXPECT_GT(std::abs(solve(scene, r, s).illuminance[0] - 250), 25) << "nothing is compared";
}

// Errors of replicates fall with the root of the trajectories: a pair of halves of one Sobol' index would leave a part
// of it. A quarter is left of 16 times as many.
TEST(Bidirectional, ErrorFallsWithTheTrajectories)
{
  const Scene scene(rooms::litRoom(0.7));
  Receivers r;
  for (int i = 0; i < 20; ++i)
  {
    r.points.push_back({0.6 + 0.2 * i, 2.4, 0});
    r.normals.push_back({0, 0, 1});
  }
  double squares[2] = {};
  for (const bool more : {false, true})
  {
    Settings s;
    s.method = Method::Bidirectional;
    s.trajectories = more ? 32768 : 2048;
    for (const double e : solve(scene, r, s).standardError)
      squares[more] += e * e;
  }
  EXPECT_LT(std::sqrt(squares[1] / squares[0]), 0.35);
}
