// SPDX-License-Identifier: BSD-3-Clause
// When a solve stops, what it shows on the way, and what it refuses.
#include <gtest/gtest.h>

#include <thread>

#include "FloorPoints.h"
#include "Student.h"
#include "estimator/solve/Solver.h"
#include "statistics/Replicates.h"

using namespace kalos;

// Stop on error: the reported half-width meets the goal at every receiver.
TEST(Solver, StopsWhenTheErrorIsReached)
{
  const Scene scene(rooms::litRoom(0.7));
  Settings s;
  s.method = Method::Local;
  s.relativeError = 0.02;
  const Result result = solve(scene, floorPoints(), s);
  for (std::size_t i = 0; i < result.illuminance.size(); ++i)
    EXPECT_LE(studentQuantile(0.95, 31) * result.standardError[i], 0.02 * result.illuminance[i]);
  EXPECT_GT(result.trajectories, 2048);
  s.trajectories = 4096;
  EXPECT_EQ(solve(scene, floorPoints(), s).trajectories, 4096);
}

TEST(Solver, StopsWhenTheTimeIsUp)
{
  const Scene scene(rooms::furnace(0.9, 100));
  Settings s;
  s.seconds = 0.5;
  const Result result = solve(scene, floorPoints(), s);
  EXPECT_GT(result.seconds, 0.2);
  EXPECT_LT(result.seconds, 5);
}

// Intermediate results are estimates too, at every round.
TEST(Solver, ShowsEveryRound)
{
  const Scene scene(rooms::litRoom(0.6));
  const Settings s = quick(Method::Compensated, 6400);
  const Result alone = solve(scene, floorPoints(), s);
  std::vector<long long> shown;
  Result last;
  const Result result = solve(scene, floorPoints(), s, {}, [&](const Result& soFar) {
    shown.push_back(soFar.trajectories);
    last = soFar;
    for (std::size_t i = 0; i < soFar.illuminance.size(); ++i)
      EXPECT_LT(std::abs(soFar.illuminance[i] - alone.illuminance[i]),
                allowed(soFar, alone, 12) * std::hypot(soFar.standardError[i], alone.standardError[i]))
          << soFar.trajectories << " trajectories, point " << i;
  });
  EXPECT_EQ(shown.front(), 8);
  for (std::size_t i = 1; i < shown.size(); ++i)
    EXPECT_LE(shown[i], std::max(shown[i - 1] + 8, 3 * shown[i - 1] / 2));
  EXPECT_EQ(shown.back(), 6400);
  EXPECT_EQ(last.illuminance, result.illuminance);
  EXPECT_EQ(last.trusted, result.trusted);
}

// A few trajectories that happen to agree are no reason to stop.
TEST(Solver, JudgesItsGoalNotBeforeTheFirstFullRound)
{
  Settings s = quick(Method::Compensated, 0);
  s.relativeError = 0.9;
  const Result result = solve(Scene(rooms::litRoom(0.6)), floorPoints(), s, {}, [](const Result&) {});
  EXPECT_GE(result.trajectories, 64 * 8);
}

TEST(Solver, PausesAreNoPartOfItsTime)
{
  const Scene scene(rooms::furnace(0.9, 100));
  Settings s;
  s.seconds = 0.3;
  int calls = 0;
  auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(400)); };
  const Result result = solve(
      scene, floorPoints(), s,
      [&](double) {
        if (++calls == 2)
          wait();
        return true;
      },
      [&](const Result& soFar) {
        if (soFar.trajectories == 32)
          wait();
      });
  EXPECT_GE(calls, 2);
  EXPECT_GT(result.seconds, 0.1) << "the pauses of 0.8 s are not counted as work";
  EXPECT_LT(result.seconds, 0.7);
}

TEST(Solver, AbortsWhenAskedToWithTheRoundsThatWereComplete)
{
  const Scene scene(rooms::furnace(0.9, 100));
  Settings s;
  s.relativeError = 1e-6;
  const Result result = solve(scene, floorPoints(), s, [&](double f) {
    EXPECT_GE(f, 0);
    EXPECT_LE(f, 1);
    return f == 0;  // with a goal, progress starts with the second round
  });
  EXPECT_TRUE(result.aborted);
  EXPECT_LT(result.seconds, 5);
  ASSERT_GT(result.trajectories, 0);
  EXPECT_EQ(result.audit.back().subject, "stopped");
  for (std::size_t r = 0; r < result.illuminance.size(); ++r)
  {
    if (underABox(floorPoints().points[r]))
      continue;
    EXPECT_LT(std::abs(result.illuminance[r] - 1000), 7 * result.standardError[r]) << r;  // false alarms below 1e-6
    EXPECT_LT(result.standardError[r], 200) << r;
  }
}

TEST(Solver, AbortedInItsFirstRoundHasNoResult)
{
  const Scene scene(rooms::furnace(0.9, 100));
  Settings s;
  s.trajectories = 1LL << 40;
  const Result result = solve(scene, floorPoints(), s, [](double) { return false; });
  EXPECT_TRUE(result.aborted);
  EXPECT_EQ(result.trajectories, 0);
  EXPECT_TRUE(result.illuminance.empty());
}

TEST(Solver, RefusesSettingsWithoutMeaning)
{
  const Scene scene(rooms::litRoom(0.5));
  auto message = [&](auto change) -> std::string {
    Settings s;
    Receivers r = floorPoints();
    change(s, r);
    try
    {
      solve(scene, r, s);
      return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.trajectories = -1; }),
            "trajectories: must be 0 (automatic) or more");
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.relativeError = 1; }), "error: must lie in [0, 1)");
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.seconds = -1; }), "time: must be 0 (no limit) or more seconds");
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.threads = -1; }), "threads: must be 0 (all) or more");
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.delta = NAN; }),
            "delta: is nan m, expected 0 (automatic) up to the size of the scene, 5.000000 m");
  EXPECT_EQ(message([](Settings& s, Receivers&) { s.epsilon = NAN; }),
            "epsilon: is nan m, expected 0 (automatic) up to the size of the scene, 5.000000 m");
  EXPECT_EQ(message([](Settings&, Receivers& r) { r.normals.pop_back(); }),
            "receivers: one normal per point is expected");
  EXPECT_EQ(message([](Settings&, Receivers& r) { r.points[2].x = NAN; }), "receiver 2: coordinates must be finite");
  EXPECT_EQ(message([](Settings&, Receivers& r) {
              r.normals[1] = {0, 0, 2};
            }),
            "receiver 1: its normal must be a unit vector");
}
