// SPDX-License-Identifier: BSD-3-Clause
// Measured luminaires in the estimators: the same lamp as point, rectangle and table gives the same lux.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "Student.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
// cos(theta)^power below the axis, every half degree.
std::shared_ptr<const CandelaTable> cosineTable(double power = 1)
{
  std::vector<double> angles, candela;
  for (int i = 0; i <= 180; ++i)
    angles.push_back(0.5 * i);
  for (int plane = 0; plane < 2; ++plane)
    for (double a : angles)
      candela.push_back(a == 90 ? 0 : std::pow(std::cos(a * pi / 180), power));
  return std::make_shared<CandelaTable>(std::vector<double>{0, 360}, angles, candela, CandelaTable::Pole::Axis);
}

Luminaire measured(double side)
{
  Luminaire lamp;
  lamp.position = {2.5, 2.5, 4.999};
  lamp.flux = 10000;
  lamp.distribution = Distribution::Measured;
  lamp.table = cosineTable();
  lamp.sideU = {side, 0, 0};
  lamp.sideV = {0, side, 0};
  return lamp;
}

SceneDescription room(const Luminaire& lamp, double reflectance)
{
  SceneDescription scene = rooms::litRoom(reflectance);
  scene.luminaires = {lamp};
  return scene;
}

Result solveAt(const SceneDescription& scene, std::vector<Vec3> points, long long trajectories = 6400)
{
  Receivers receivers;
  receivers.points = std::move(points);
  receivers.normals.assign(receivers.points.size(), {0, 0, 1});
  Settings settings;
  settings.trajectories = trajectories;
  settings.seed = 3;
  return solve(Scene(scene), receivers, settings);
}

void expectSame(const Result& a, const Result& b, double roundOff, double largestError)
{
  for (std::size_t i = 0; i < a.illuminance.size(); ++i)
  {
    const double error = std::hypot(a.standardError[i], b.standardError[i]);
    EXPECT_NEAR(a.illuminance[i], b.illuminance[i], allowed(a, b, 16) * error + roundOff * b.illuminance[i])
        << "receiver " << i;
    EXPECT_LT(error, largestError * b.illuminance[i]);
  }
}

const std::vector<Vec3> floorPoints{{2.5, 2.5, 0}, {0.5, 4, 0}, {1, 1, 2}, {4.9, 0.2, 1}};
}  // namespace

// Chords of a half-degree table lie at most 1e-5 below the cosine; that much of flux and intensity is shared.
TEST(Openings, pointTableIsThePoint)
{
  Luminaire point = measured(0);
  point.distribution = Distribution::Lambertian;
  expectSame(solveAt(room(measured(0), 0.5), floorPoints), solveAt(room(point, 0.5), floorPoints), 3e-5, 0.02);
}

// Near an opening of Lambertian distribution it is the luminous rectangle, wherever one stands, in rooms with
// reflection.
TEST(Openings, nearOpeningIsTheRectangle)
{
  Luminaire rectangle = measured(1.2);
  rectangle.distribution = Distribution::Lambertian;
  const std::vector<Vec3> close{{2.5, 2.5, 4.9}, {2.5, 2.5, 4}, {3, 3.3, 4.6}, {1, 1, 2}, {0.1, 2.5, 4.5}};
  expectSame(solveAt(room(measured(1.2), 0.5), close, 25600), solveAt(room(rectangle, 0.5), close, 25600), 3e-5, 0.02);
}

// The same with a box in the way.
TEST(Openings, shadowsOfOpenings)
{
  auto scene = [](Distribution distribution) {
    Luminaire lamp = measured(1.2);
    lamp.distribution = distribution;
    SceneDescription description = room(lamp, 0);
    rooms::addBox(description, {2.4, 2.4, 3.5}, {0.9, 1.2, 0.5}, 0, false);
    return description;
  };
  const std::vector<Vec3> under{{2.5, 2.3, 3}, {3.2, 2.5, 2}, {2.2, 3, 3.3}};
  expectSame(solveAt(scene(Distribution::Measured), under, 25600),
             solveAt(scene(Distribution::Lambertian), under, 25600), 3e-5, 0.1);
}

// From 5 sizes on it is a point; the area's correction there is about (side / distance)^2 / 12 of the value and less.
TEST(Openings, farOpeningIsAPoint)
{
  const std::vector<Vec3> far{{2.5, 2.5, 0}, {0.5, 4, 0}};
  const Result area = solveAt(room(measured(0.3), 0), far), point = solveAt(room(measured(0), 0), far);
  for (std::size_t i = 0; i < far.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(area.illuminance[i], point.illuminance[i]);
    EXPECT_EQ(area.standardError[i], 0);
  }
}

// A narrow beam through an opening lights a patch of the opening's size, not a point: at 0.1 m it is even.
TEST(Openings, narrowBeamsSpreadOverTheOpening)
{
  Luminaire lamp = measured(1);
  lamp.table = cosineTable(400);
  const Result r = solveAt(room(lamp, 0), {{2.5, 2.5, 4.899}, {2.2, 2.7, 4.899}, {1.5, 2.5, 4.899}}, 25600);
  EXPECT_NEAR(r.illuminance[0], 10000, 10000 * 0.02 + 4 * r.standardError[0]);  // its flux over 1 m2
  EXPECT_NEAR(r.illuminance[1], 10000, 10000 * 0.02 + 4 * r.standardError[1]);
  EXPECT_LT(r.illuminance[2], 1);
}

// A luminaire that shines both ways, hung freely: the furnace's balance holds, half of the light goes up.
TEST(Openings, bothSidesEmit)
{
  std::vector<double> candela(4, 1.0);
  Luminaire lamp = measured(0.5);
  lamp.position = {2.5, 2.5, 2.5};
  lamp.table = std::make_shared<CandelaTable>(std::vector<double>{0, 360}, std::vector<double>{0, 180}, candela,
                                              CandelaTable::Pole::Axis);
  Receivers receivers;
  receivers.points = {{2.5, 2.5, 2}, {2.5, 2.5, 3}};
  receivers.normals = {{0, 0, 1}, {0, 0, -1}};
  Settings settings;
  settings.trajectories = 25600;
  const Result r = solve(Scene(room(lamp, 0)), receivers, settings);
  // Mean over the opening of I cos / d^2, by a fine grid.
  double truth = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
    {
      const double x = 0.5 * ((i + 0.5) / n - 0.5), y = 0.5 * ((k + 0.5) / n - 0.5), d2 = x * x + y * y + 0.25;
      truth += 10000 / (4 * pi) * 0.5 / std::sqrt(d2) / d2 / (n * n);
    }
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(r.illuminance[i], truth, 1e-5 * truth + 4.5 * r.standardError[i]);
    EXPECT_LT(r.standardError[i], 0.02 * truth);
  }
}
