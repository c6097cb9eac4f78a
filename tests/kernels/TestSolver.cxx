// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "Student.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Solver.h"
#include "statistics/Replicates.h"

using namespace kalos;

static bool underABox(const Vec3& p)
{
  return (p.x > 1 && p.x < 2.2 && p.y > 1 && p.y < 2.4) || (p.x > 3 && p.x < 4.1 && p.y > 2.4 && p.y < 3.4);
}

static Receivers floorPoints()
{
  Receivers r;
  for (double x : {0.7, 1.6, 2.4, 3.9})
    for (double y : {0.6, 2.1, 4.2})
    {
      r.points.push_back({x, y, 0});
      r.normals.push_back({0, 0, 1});
    }
  return r;
}

static Settings quick(Method method = Method::Local, long long trajectories = 6400)
{
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.method = method;
  s.trajectories = trajectories;
  return s;
}

TEST(Solver, ThreadsDoNotChangeABit)
{
  const Scene scene(rooms::furnace(0.6, 100));
  for (Method method : {Method::Local, Method::Direct, Method::Compensated, Method::SphereExact, Method::Disc})
  {
    Settings s = quick(method, 3200);
    s.threads = 1;
    const Result one = solve(scene, floorPoints(), s);
    for (int threads : {2, 4})
    {
      s.threads = threads;
      const Result many = solve(scene, floorPoints(), s);
      EXPECT_EQ(one.illuminance, many.illuminance);
      EXPECT_EQ(one.standardError, many.standardError);
    }
  }
}

// validation.md 1: E = M0/(1 - rho) everywhere. 12 points; Student with 31 degrees of freedom and Sidak for 12: |t|
// < 4.6, false alarm 1e-3 (the seed is fixed, so this is decided once).
TEST(Solver, FurnaceAwayFromEdges)
{
  const Scene scene(rooms::furnace(0.6, 100));
  const Result result = solve(scene, floorPoints(), quick(Method::Local, 64000));
  for (std::size_t i = 0; i < result.illuminance.size(); ++i)
  {
    if (underABox(floorPoints().points[i]))
      continue;
    EXPECT_LT(std::abs(result.illuminance[i] - 250), 4.6 * result.standardError[i]) << "point " << i;
    EXPECT_LT(result.standardError[i], 10);
  }
}

// The furnace again, 1 km away and with a lamp 1 mm from the wall: the offsets scale with the hit points.
TEST(Solver, TranslationOneKilometreAway)
{
  SceneDescription here = rooms::litRoom(0.6), there = here;
  here.luminaires[0].position = there.luminaires[0].position = {0.001, 2.5, 2.5};
  here.luminaires[0].axis = there.luminaires[0].axis = {1, 0, 0};
  const Vec3 shift{1024, -2048, 512};
  rooms::translate(there, shift);
  Receivers nearby = floorPoints(), away = nearby;
  for (Vec3& p : away.points)
    p += shift;
  const Result a = solve(Scene(here), nearby, quick()), b = solve(Scene(there), away, quick());
  for (std::size_t i = 0; i < a.illuminance.size(); ++i)
    EXPECT_NEAR(b.illuminance[i], a.illuminance[i], 1e-3 * a.illuminance[i]);
  EXPECT_GT(a.direct[0], 0);
}

// Two methods, one truth: direct simulation on 0.2 m cells against local estimation. Sidak for 12 points, |z| < 4.6.
TEST(Solver, DirectSimulationAgreesWithLocalEstimation)
{
  SceneDescription d = rooms::litRoom(0.6);
  d.luminaires[0].position = {2.5, 2.5, 2.5};
  d.luminaires[0].distribution = Distribution::Isotropic;
  const Scene scene(d);
  Settings s = quick(Method::Direct, 3200000);
  s.epsilon = 0.1;
  const Result direct = solve(scene, floorPoints(), s);
  const Result local = solve(scene, floorPoints(), quick(Method::Local, 64000));
  for (std::size_t i = 0; i < direct.illuminance.size(); ++i)
  {
    const double error = std::hypot(direct.standardError[i], local.standardError[i]);
    EXPECT_LT(std::abs(direct.illuminance[i] - local.illuminance[i]), 4.6 * error + 0.002 * local.illuminance[i]);
    EXPECT_LT(error, 0.03 * local.illuminance[i]);
  }
}

// A rectangle behind a screen: the polygon formula less the hidden part against plain sums over a fine grid of the
// rectangle. |t| < 4.6 at 4 points (false alarm below 1e-3).
TEST(Solver, RectangleBehindAScreen)
{
  SceneDescription d;
  rooms::addQuad(d, {0.2, -2, 1}, {2, 0, 0}, {0, 4, 0}, rooms::addMaterial(d, 0));
  Luminaire panel;
  panel.position = {0, 0, 2};
  panel.sideU = {1.2, 0, 0};
  panel.sideV = {0, 0.6, 0};
  panel.flux = 3600;
  d.luminaires.push_back(panel);
  const Scene scene(d);
  Receivers r;
  for (double x : {-1.0, 0.0, 0.2, 0.5})
  {
    r.points.push_back({x, 0.1, 0});
    r.normals.push_back({0, 0, 1});
  }
  const Result result = solve(scene, r, quick(Method::Local, 32000));
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    double exact = 0;
    const int n = 1200;
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n / 2; ++l)
      {
        const Vec3 y{-0.6 + 1.2 * (k + 0.5) / n, -0.3 + 1.2 * (l + 0.5) / n, 2};
        if (0.5 * (y.x + r.points[i].x) > 0.2)
          continue;  // the screen reaches from x = 0.2 on at half height
        const double d2 = dot(y - r.points[i], y - r.points[i]);
        exact += 5000 * 4 / (pi * d2 * d2) * (1.2 / n) * (1.2 / n);
      }
    EXPECT_LT(std::abs(result.illuminance[i] - exact), 4.6 * result.standardError[i] + 1e-3 * exact) << "point " << i;
  }
}

// A mirror image, a scaled scene and superposition (validation.md 7), on the same random numbers: exact up to rounding.
TEST(Solver, ScalingByTenDividesByAHundred)
{
  SceneDescription small = rooms::litRoom(0.7), large = small;
  for (Vec3& p : large.points)
    p = 10.0 * p;
  large.luminaires[0].position = 10.0 * large.luminaires[0].position;
  Receivers near = floorPoints(), far = near;
  for (Vec3& p : far.points)
    p = 10.0 * p;
  const Result a = solve(Scene(small), near, quick()), b = solve(Scene(large), far, quick());
  for (std::size_t i = 0; i < a.illuminance.size(); ++i)
    EXPECT_NEAR(100 * b.illuminance[i], a.illuminance[i], 1e-3 * a.illuminance[i]);
}

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

// What is shown on the way is an estimate too, at every round.
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

// L = rho E/pi + M0/pi in the furnace, for every pixel away from edges.
TEST(LuminanceImage, Furnace)
{
  const Scene scene(rooms::furnace(0.6, 100));
  Camera camera;
  camera.position = {2.5, 0.3, 2.6};
  camera.target = {2.5, 5, 3.6};
  camera.fieldOfView = 20;
  camera.width = camera.height = 5;
  const LuminanceResult image = solveLuminance(scene, camera, quick(Method::Local, 32000));
  const double truth = (0.6 * 250 + 100) / pi;
  for (std::size_t i = 0; i < image.luminance.size(); ++i)
  {
    EXPECT_LT(std::abs(image.luminance[i] - truth), 4.9 * image.standardError[i]);  // Sidak for 25, false alarm 1e-3
    EXPECT_LT(image.standardError[i], 0.1 * truth);
  }
}

TEST(LuminanceImage, RefusesCamerasInsideOut)
{
  const Scene scene(rooms::litRoom(0.5));
  auto message = [&](auto change) -> std::string {
    Camera camera;
    camera.position = {2.5, 0.3, 2.6};
    camera.target = {2.5, 5, 2.6};
    change(camera);
    try
    {
      solveLuminance(scene, camera, quick());
      return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  EXPECT_EQ(message([](Camera& c) { c.fieldOfView = 180; }),
            "camera: the field of view must lie between 0 and 180 degrees");
  EXPECT_EQ(message([](Camera& c) { c.width = 0; }), "camera: the resolution must be at least 1 x 1");
  EXPECT_EQ(message([](Camera& c) { c.target = c.position; }), "camera: position and target must differ");
  EXPECT_EQ(message([](Camera& c) { c.up = {0, 1, 0}; }), "camera: up must not be parallel to the line of sight");
  EXPECT_EQ(message([](Camera& c) { c.up.x = NAN; }), "camera: coordinates must be finite");
}
