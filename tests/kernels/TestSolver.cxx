// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a solve: closed forms, symmetries, methods against each other.
#include <gtest/gtest.h>

#include "FloorPoints.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

TEST(Solver, ThreadsDoNotChangeABit)
{
  const Scene scene(rooms::furnace(0.6, 100));
  for (Method method : {Method::Local, Method::Direct, Method::Compensated, Method::SphereExact, Method::Disc,
                        Method::Paths, Method::PhotonMap})
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
