// SPDX-License-Identifier: BSD-3-Clause
// When a solve stops for its error, and that its intervals still cover the truth.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/AdaptiveSampling.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
constexpr int replicates = 16;

// Two receivers of 100 lx and 0.01 lx whose replicates alternate by `spread` lx about that, and one that is dark; after
// n trajectories of each.
Tally alternating(double spread, double n = 1)
{
  Tally tally(Scene(rooms::litRoom(0.5)), 3, replicates);
  for (int p = 0; p < replicates; ++p)
  {
    *tally.total(0, p) = n * (100 + (p % 2 ? spread : -spread));
    *tally.total(1, p) = n * (0.01 + (p % 2 ? spread : -spread));
  }
  return tally;
}

Result judged(const Settings& settings, const Tally& tally)
{
  Result result;
  tally.write(1, result);
  Goal(settings, replicates).judge(result);
  return result;
}

std::string reasonOfError(const Result& result)
{
  for (const AuditLine& line : result.audit)
    if (line.subject == "error")
      return line.reason;
  return {};
}

constexpr char missed = static_cast<char>(GoalStatus::Missed), within = static_cast<char>(GoalStatus::WithinError),
               below = static_cast<char>(GoalStatus::BelowFloor);
}  // namespace

// The half-width of replicates that alternate by s is t(0.95, 15) s / sqrt(15) = 2.1314 s / 3.87298 = 0.55034 s.
TEST(Goal, IsRelativeOrAbsolute)
{
  Settings s;
  s.relativeError = 0.01;
  s.errorFloor = 0.5;
  const Result half = judged(s, alternating(0.9));
  EXPECT_EQ(half.goal, (std::vector<char>{within, below, below}));
  EXPECT_EQ(half.errorFloor, 0.5);
  EXPECT_NEAR(Goal(s, replicates).distance(alternating(0.9), 1), 0.55034 * 0.9 / 0.5, 1e-4);
  EXPECT_EQ(judged(s, alternating(1)).goal, (std::vector<char>{within, missed, below}));
  EXPECT_EQ(judged(s, alternating(2)).goal, (std::vector<char>{missed, missed, below}));
}

TEST(Goal, FloorIsAutomatic)
{
  Settings s;
  s.relativeError = 0.03;
  const double floor = 0.03 * 0.01 * 100.01 / 3;
  EXPECT_NEAR(judged(s, alternating(0)).errorFloor, floor, 1e-12);
  EXPECT_EQ(judged(s, alternating(0.9 * floor / 0.55034)).goal, (std::vector<char>{within, below, below}));
  EXPECT_EQ(judged(s, alternating(1.1 * floor / 0.55034)).goal, (std::vector<char>{within, missed, below}));
  s.errorFloor = 0;
  EXPECT_EQ(judged(s, alternating(1e-3)).goal, (std::vector<char>{within, missed, below}));
  s.relativeError = 0;
  EXPECT_TRUE(judged(s, alternating(1)).goal.empty());
}

// Hardly any light gets under a box that stands 1 mm off the floor, a hundredth of a per mille of what comes beside
// it: a solve to 10 % ends when that is known well enough, and says so.
TEST(Goal, EndsWhereHardlyAnyLightComes)
{
  SceneDescription room = rooms::litRoom(0.5);
  rooms::addBox(room, {1, 1, 0.001}, {1, 1, 1}, 0, false);
  const Scene scene(room);
  Receivers receivers;
  receivers.points = {{1.5, 1.5, 0}, {3.5, 3.5, 0}, {4, 1, 0}};
  receivers.normals.assign(3, {0, 0, 1});
  Settings s;
  s.relativeError = 0.1;
  s.trajectories = 1 << 20;
  const Result result = solve(scene, receivers, s);
  EXPECT_LT(result.illuminance[0], 0.01 * result.illuminance[1]);
  EXPECT_EQ(result.goal, (std::vector<char>{below, within, within}));
  EXPECT_LT(result.trajectories, s.trajectories / 16);
  EXPECT_NE(reasonOfError(result), "");
}

// Distances of 0.55034 * 0.9 / 1 and 0.55034 * 0.9 / 0.5, and nothing in the dark: the mean square of all three,
// neighbours of each other, times the pilot's trajectories.
TEST(AdaptiveSampling, NeedsAreTheSquaresOfDistancesAmongNeighbours)
{
  Settings s;
  s.relativeError = 0.01;
  s.errorFloor = 0.5;
  const Goal goal(s, replicates);
  const long long n = AdaptiveSampling::pilotTrajectories;
  const AdaptiveSampling plan(goal, alternating(0.9, n));
  const double first = 0.55034 * 0.9, second = 2 * first, needed = n * (first * first + second * second) / 3;
  for (const double each : plan.needed())
    EXPECT_NEAR(each, needed, 1e-3 * needed);
  // Enough by the plan, and by the interval: the second receiver is 0.99 of the way beyond.
  const auto enough = static_cast<long long>(needed) + 1;
  EXPECT_EQ(plan.converged(goal, alternating(0.9, enough), enough), (std::vector<char>{1, 1, 1}));
  EXPECT_EQ(plan.converged(goal, alternating(1.1, enough), enough), (std::vector<char>{1, 0, 1}));
  EXPECT_EQ(plan.converged(goal, alternating(0.9, enough - 2), enough - 2), (std::vector<char>{0, 0, 0}));
}

// A converged receiver keeps its mean and error while the others' sums are divided by more and more trajectories.
TEST(AdaptiveSampling, RestingReceiversKeepTheirEstimates)
{
  Tally tally = alternating(0.9);
  tally.noteScore(0, 0, 30);
  const MeanAndError before = tally.summary(0, 1);
  const double share = tally.largestShare(0, 1);
  tally.setConverged({1, 0, 0});
  EXPECT_EQ(tally.active(), 2u);
  tally.keepConverged(1, 3);
  tally.keepConverged(4, 6);
  EXPECT_NEAR(tally.summary(0, 10).mean, before.mean, 1e-9 * before.mean);
  EXPECT_NEAR(tally.summary(0, 10).standardError, before.standardError, 1e-9);
  EXPECT_NEAR(tally.largestShare(0, 10), share, 1e-12);
  EXPECT_EQ(tally.trajectories(0, 10), 1);
  EXPECT_EQ(tally.trajectories(1, 10), 10);
  EXPECT_NEAR(tally.summary(1, 10).mean, 0.001, 1e-9);
}

// 60 receivers, some beside a box and some in the open, to 1 %: the same values with less work, each within 10.4
// standard errors (7 degrees of freedom: false alarm 6e-3 over all).
TEST(AdaptiveSampling, SavesWorkAndMovesNoValue)
{
  SceneDescription room = rooms::litRoom(0.5);
  rooms::addBox(room, {1, 1, 0}, {1, 1.5, 2}, 0, false);
  const Scene scene(room);
  Receivers receivers;
  for (int i = 0; i < 60; ++i)
    receivers.points.push_back({i < 12 ? 0.05 + 0.07 * i : 2.2 + 0.04 * i, 1.6, 0});
  receivers.normals.assign(receivers.points.size(), {0, 0, 1});
  for (const Method method : {Method::Gathered, Method::Compensated})
  {
    Settings s;
    s.method = method;
    s.relativeError = 0.01;
    double plannedRays = 0, evenRays = 0;  // when the goal is reached is a matter of chance: three seeds of each
    for (std::uint64_t seed = 1; seed <= 6; seed += 2)
    {
      s.disabled = {};
      s.seed = seed;
      const Result planned = solve(scene, receivers, s);
      s.disabled = {Technique::Effort};
      s.seed = seed + 1;
      const Result even = solve(scene, receivers, s);
      plannedRays += planned.rays;
      evenRays += even.rays;
      for (std::size_t i = 0; i < receivers.points.size(); ++i)
      {
        const double error = std::hypot(planned.standardError[i], even.standardError[i]);
        EXPECT_NEAR(planned.illuminance[i], even.illuminance[i], 10.4 * error + 0.002 * even.illuminance[i]) << i;
        EXPECT_NE(planned.goal[i], missed);
      }
    }
    EXPECT_LT(plannedRays, 0.8 * evenRays);
  }
}

TEST(Goal, SaysWhatWasMissedAndWhy)
{
  const Scene scene(rooms::furnace(0.5, 100));
  Receivers receivers;
  receivers.points = {{2.5, 2.5, 0}, {0.5, 0.5, 0}};
  receivers.normals.assign(2, {0, 0, 1});
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.relativeError = 1e-4;
  s.trajectories = 512;
  const Result result = solve(scene, receivers, s);
  EXPECT_EQ(result.goal, (std::vector<char>{missed, missed}));
  EXPECT_EQ(reasonOfError(result), "all trajectories allowed were used before");
}

// 200 solves of a white furnace of 200 lx that stop at 4 %: 4 receivers each, from 1 mm to 2.5 m of an edge. The share
// of intervals that cover it lies between 90 and 98 % (95 % of 800, were they independent, has a standard error of 0.8
// %) and the mean is right within 4.4 standard errors (false alarm 1e-5): stopping on the estimate itself biases
// neither.
TEST(Goal, IntervalsCoverTheTruthWhenTheErrorStopsTheSolve)
{
  const Scene scene(rooms::furnace(0.5, 100));
  Receivers receivers;
  for (double x : {0.001, 0.05, 0.5, 2.5})
  {
    receivers.points.push_back({x, 2.4, 0});
    receivers.normals.push_back({0, 0, 1});
  }
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.relativeError = 0.04;
  const int seeds = 200;
  int covered = 0, rounds = 0;
  double sum = 0, squares = 0;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    s.seed = seed;
    const Result result = solve(scene, receivers, s);
    const double quantile = studentQuantile(0.95, result.replicates - 1);
    double mean = 0;
    for (std::size_t r = 0; r < receivers.points.size(); ++r)
    {
      EXPECT_EQ(result.goal[r], within);
      covered += std::abs(result.illuminance[r] - 200) <= quantile * result.standardError[r];
      mean += result.illuminance[r] / 4;
    }
    rounds += result.trajectories > 64 * 32;
    sum += mean;
    squares += mean * mean;
  }
  EXPECT_GT(rounds, seeds / 4) << "the goal must decide when it ends";
  const double mean = sum / seeds, error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  EXPECT_LT(error, 0.5);
  EXPECT_LT(std::abs(mean - 200), 4.4 * error);
  EXPECT_GE(covered, 0.90 * 4 * seeds);
  EXPECT_LE(covered, 0.98 * 4 * seeds);
}
