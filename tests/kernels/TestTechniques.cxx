// SPDX-License-Identifier: BSD-3-Clause
// Every technique can be disabled, and no mean moves.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/control/Techniques.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
// A room under a luminous panel and a lamp, with two boxes or empty.
SceneDescription panelRoom(bool empty)
{
  SceneDescription room = empty ? rooms::litRoom(0.5) : rooms::furnace(0.5, 0);
  room.luminaires = rooms::litRoom(0.5).luminaires;
  Luminaire panel;
  panel.position = {1.5, 3.5, 4.9};
  panel.axis = {0, 0, -1};
  panel.sideU = {1, 0, 0};
  panel.sideV = {0, -1, 0};
  panel.flux = 6000;
  panel.distribution = Distribution::Lambertian;
  room.luminaires.push_back(panel);
  return room;
}

enum class Kind
{
  Furnished,
  Empty,
  Luminous,
  Satin,   // furnished, all surfaces glossy
  Goaled,  // furnished, solved to an error
  Grid     // furnished, with many receivers, gathered
};

// Where a technique saves time.
Kind roomFor(const std::string& technique)
{
  return technique == "convex"       ? Kind::Empty
         : technique == "paths"      ? Kind::Luminous
         : technique == "effort"     ? Kind::Goaled
         : technique == "neighbours" ? Kind::Grid
         : technique == "highlights" ? Kind::Satin
                                     : Kind::Furnished;
}

// Receivers in the open, in the panel's half-shadow and 2 mm from an edge.
Result solveRoom(Kind kind, const std::string& without, std::uint64_t seed)
{
  SceneDescription room = kind == Kind::Luminous ? rooms::furnace(0.5, 100) : panelRoom(kind == Kind::Empty);
  for (Material& m : room.materials)
  {
    m.specular = kind == Kind::Satin ? 0.2 : 0;
    m.roughness = 0.4;
  }
  const Scene scene(room);
  Receivers receivers;
  receivers.points = {{3.75, 1.2, 2}, {0.9, 2.2, 0}, {0.002, 2.5, 0}, {2.5, 1.25, 2.5}, {4.6, 4.6, 1}};
  for (int i = 0; (kind == Kind::Goaled || kind == Kind::Grid) && i < 40; ++i)
    receivers.points.push_back({0.5 + 0.1 * i, 2.5, 4});
  receivers.normals.assign(receivers.points.size(), {0, 0, 1});
  Settings s;
  s.trajectories = 4800;
  if (kind == Kind::Grid)
    s.method = Method::Gathered;
  if (kind == Kind::Goaled)
  {
    s.trajectories = 200000;
    s.relativeError = 0.02;
  }
  s.seed = seed;
  s.disabled = TechniqueSet::named(without);
  EXPECT_EQ(s.disabled.names(), without);
  return solve(scene, receivers, s);
}

struct Mean
{
  double value = 0, variance = 0;
};

std::vector<Mean> meanOverSeeds(Kind kind, const std::string& without, std::uint64_t firstSeed)
{
  constexpr int seeds = 16;
  std::vector<Mean> means(5);
  for (int i = 0; i < seeds; ++i)
  {
    const Result result = solveRoom(kind, without, firstSeed + i);
    for (std::size_t r = 0; r < means.size(); ++r)
    {
      means[r].value += result.illuminance[r] / seeds;
      means[r].variance += result.standardError[r] * result.standardError[r] / seeds / seeds;
    }
  }
  return means;
}

class Techniques : public testing::TestWithParam<const char*>
{
};
}  // namespace

// 16 seeds with and without, independent: differences of 5 receivers within 4.9 standard errors each, false alarm 1e-6
// each, 2.5e-5 over all techniques (Sidak); and a standard error below 1.2 %, so that a bias of a few percent is seen.
TEST_P(Techniques, MoveNoMean)
{
  const std::string name = GetParam();
  const Kind kind = roomFor(name);
  const std::vector<Mean> with = meanOverSeeds(kind, "", 100), without = meanOverSeeds(kind, name, 200);
  for (std::size_t r = 0; r < with.size(); ++r)
  {
    const double error = std::sqrt(with[r].variance + without[r].variance);
    EXPECT_LT(std::abs(with[r].value - without[r].value), 4.9 * error) << name << ", receiver " << r;
    EXPECT_LT(error, 0.012 * with[r].value) << name << ", receiver " << r;
  }
}

// The same seed traces the same trajectories.
TEST_P(Techniques, ChangeTheWork)
{
  const std::string name = GetParam();
  const Kind kind = roomFor(name);
  const Result with = solveRoom(kind, "", 1), without = solveRoom(kind, name, 1);
  if (kind == Kind::Empty)
    for (std::size_t r = 0; r < with.illuminance.size(); ++r)  // its shadow rays find nothing
      EXPECT_NEAR(with.illuminance[r], without.illuminance[r], 1e-5 * with.illuminance[r]);
  else
    EXPECT_NE(with.illuminance, without.illuminance) << "other random numbers or weights";
  if (name == "stratified")  // as many, but for roulette
    EXPECT_NEAR(static_cast<double>(without.rays), static_cast<double>(with.rays), 0.05 * with.rays);
  else  // neighbours and highlights have more rays, of which each finds more
    EXPECT_EQ(without.rays > with.rays, name != "neighbours" && name != "highlights")
        << without.rays << " against " << with.rays;
  EXPECT_EQ(with.direct != without.direct,
            name != "picked" && name != "convex" && name != "near" && name != "neighbours" && name != "highlights");
}

INSTANTIATE_TEST_SUITE_P(Each, Techniques,
                         testing::Values("stratified", "picked", "convex", "near", "paths", "neighbours", "effort",
                                         "highlights", "exact-direct"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(TechniqueNames, AreListedWhenOneIsWrong)
{
  EXPECT_EQ(TechniqueSet::named("").names(), "");
  EXPECT_EQ(TechniqueSet::named("near,stratified").names(), "stratified,near");
  try
  {
    TechniqueSet::named("near,walls");
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(
        error.what(),
        "disable: 'walls' is not a technique, expected some of stratified, picked, convex, near, paths, neighbours, "
        "effort, highlights, exact-direct");
  }
}
