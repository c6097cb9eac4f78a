// SPDX-License-Identifier: BSD-3-Clause
// Panes of glass: what one does to light, and rooms with windows.
#include <gtest/gtest.h>

#include "Skies.h"
#include "Student.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Daylight.h"
#include "material/Glass.h"

using namespace skies;

namespace
{
std::shared_ptr<const Glass> pane(double transmittance, double index)
{
  return std::make_shared<const Glass>(transmittance, index);
}

std::uint32_t addGlass(SceneDescription& scene, double transmittance, double index)
{
  scene.materials.emplace_back();
  scene.materials.back().glass = pane(transmittance, index);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

Result solved(const SceneDescription& description, const Receivers& receivers, Method method, long long trajectories)
{
  Settings settings;
  settings.method = method;
  settings.trajectories = trajectories;
  return solve(Scene(description), receivers, settings);
}

constexpr Method every[] = {Method::Local, Method::Compensated, Method::Gathered};
}  // namespace

TEST(Glass, NormalTransmittanceIsTheGivenOne)
{
  for (const double tau : {0.3, 0.78, 0.88})
    EXPECT_NEAR(Glass(tau, 1.52).transmittance(1), tau, 1e-12);
  EXPECT_NEAR(Glass(0.88, 1.52).transmittance(-1), 0.88, 1e-12);
  EXPECT_EQ(Glass(1, 1).transmittance(0.1), 1);
  EXPECT_EQ(Glass(1, 1).reflectance(0.1), 0);
}

// Without absorption all is passed or reflected; a slab of n = 1.52 then passes (1 - r) / (1 + r) of each polarisation.
TEST(Glass, ConservesEnergyAtAllAngles)
{
  const Glass clear(Glass::clearest(1.52), 1.52), tinted(0.5, 1.52);
  for (double c = 0.001; c <= 1; c += 0.001)
  {
    EXPECT_NEAR(clear.transmittance(c) + clear.reflectance(c), 1, 1e-9);
    EXPECT_LT(tinted.transmittance(c) + tinted.reflectance(c), 1);
  }
  EXPECT_NEAR(clear.reflectance(1), 1 - Glass::clearest(1.52), 1e-12);
}

// The slab of CIE 171, case 5.10: absorption exp(-0.0408 / cos theta_t), tau_0 = 0.88.
TEST(Glass, IsTheSlabOfCie171)
{
  const double n = 1.52;
  for (const double degrees : {0.0, 30.0, 60.0, 80.0})
  {
    const double c = std::cos(degrees * pi / 180), t = std::sqrt(1 - (1 - c * c) / (n * n));
    const double a = std::exp(-0.0408 / t);
    double tau = 0;
    for (const double root : {(c - n * t) / (c + n * t), (n * c - t) / (n * c + t)})
      tau += 0.5 * std::pow(1 - root * root, 2) * a / (1 - std::pow(root, 4) * a * a);
    EXPECT_NEAR(Glass(0.88, n).transmittance(c), tau, 2e-3) << degrees;
  }
}

TEST(Glass, RefusesWhatNoGlassDoes)
{
  EXPECT_THROW(Glass(1.1, 1.52), std::invalid_argument);
  EXPECT_THROW(Glass(0.95, 1.52), std::invalid_argument);
  EXPECT_THROW(Glass(0.5, 0.9), std::invalid_argument);
  EXPECT_NO_THROW(Glass(1, 1));
}

TEST(Glass, DimsTheSkyByItsAngle)
{
  SceneDescription room = skylitRoom(0);
  rooms::addQuad(room, {1.5, 1.5, 3}, {1, 0, 0}, {0, 1, 0}, addGlass(room, 0.88, 1.52));
  room.sky = cie(5, 10000, 0);
  Receivers receivers;
  receivers.points = {{2, 0, 2.75}, {2, 0.25, 0}, {2, 1.75, 0}};
  receivers.normals = {{0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  const auto glass = pane(0.88, 1.52);
  constexpr double truth[] = {0.35, 1.71, 2.96};  // % of CIE 171, 5.10, to the digits printed
  for (const Method method : every)
  {
    const Result result = solved(room, receivers, method, 32768);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(result.illuminance[i] / 100, truth[i], 0.006 + allowed(result, 9) * result.standardError[i] / 100);
      EXPECT_LT(result.standardError[i], 5e-3 * result.illuminance[i]);
    }
  }
}

// A lamp behind a pane: I cos / d^2 times the transmittance, and beside it the reflection of a lamp before it.
TEST(Glass, DimsAndMirrorsLamps)
{
  SceneDescription scene;
  rooms::addQuad(scene, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, addGlass(scene, 0.78, 1.52));
  Luminaire lamp;
  lamp.position = {1, 0, 2};
  lamp.flux = 1000;
  lamp.distribution = Distribution::Isotropic;
  scene.luminaires.push_back(lamp);
  Receivers receivers;
  receivers.points = {{0, 0, 0}, {0, 0, 2.5}};
  receivers.normals = {{0, 0, 1}, {0, 0, -1}};
  const Glass glass(0.78, 1.52);
  const double intensity = 1000 / (4 * pi), through = glass.transmittance(2 / std::sqrt(5.0)),
               back = glass.reflectance(2.5 / std::sqrt(7.25)), direct = 0.5 / std::pow(1.25, 1.5);
  for (const Method method : every)
  {
    const Result result = solved(scene, receivers, method, 256);
    EXPECT_NEAR(result.illuminance[0], intensity * through * 2 / std::pow(5, 1.5), 1e-9);
    EXPECT_NEAR(result.illuminance[1], intensity * (direct + back * 2.5 / std::pow(7.25, 1.5)), 1e-9);
  }
}

// A white room cut in two by a pane: methods agree on both sides.
TEST(Glass, AllMethodsAgreeInARoomWithAWindow)
{
  SceneDescription room = rooms::litRoom(0.6);
  rooms::addQuad(room, {2, 0, 0}, {0, 5, 0}, {0, 0, 5}, addGlass(room, 0.6, 1.52));
  room.luminaires[0].position = {3.5, 2.5, 4};
  Receivers receivers;
  receivers.points = {{1, 2.5, 0}, {4, 2.5, 0}, {0, 2.5, 2.5}};
  receivers.normals = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
  const Result judge = solved(room, receivers, Method::Compensated, 65536);
  for (const Method method : {Method::Gathered, Method::Compensated})
  {
    const Result result = solved(room, receivers, method, 8192);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(result.illuminance[i], judge.illuminance[i],
                  allowed(result, judge, 6) * std::hypot(result.standardError[i], judge.standardError[i]) +
                      5e-3 * judge.illuminance[i])
          << i;
      EXPECT_LT(result.standardError[i], 0.03 * result.illuminance[i]);
    }
  }
}

// In a furnace that a pane divides, light is the same on both sides if nothing is absorbed.
TEST(Glass, ClearGlassKeepsTheFurnace)
{
  SceneDescription room = rooms::furnace(0.5, 100);
  rooms::addQuad(room, {0.5, 0, 0}, {0, 5, 0}, {0, 0, 5}, addGlass(room, Glass::clearest(1.52), 1.52));
  Receivers receivers;
  receivers.points = {{0, 2.5, 2.5}, {0.3, 0, 2.5}, {2.5, 2.5, 5}, {0.499, 2, 0}};
  receivers.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    const Result result = solved(room, receivers, method, 16384);
    for (std::size_t i = 0; i < receivers.points.size(); ++i)
    {
      EXPECT_NEAR(result.illuminance[i], 200, allowed(result, 8) * result.standardError[i] + 1) << i;
      EXPECT_LT(result.standardError[i], 4) << i;
    }
  }
}
