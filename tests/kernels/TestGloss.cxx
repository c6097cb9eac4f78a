// SPDX-License-Identifier: BSD-3-Clause
// Glossy surfaces in whole scenes.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

static Settings settings(Method method, long long trajectories)
{
  Settings s;
  s.method = method;
  s.trajectories = trajectories;
  return s;
}

// Two methods, one truth, in a room with a glossy floor, both for illuminance and for the luminance of the floor. |t|
// < 4.6.
TEST(Glossy, CompensatedAgreesWithLocal)
{
  SceneDescription d = rooms::litRoom(0.5);
  const auto satin = rooms::addMaterial(d, 0.3);
  d.materials[satin].specular = 0.3;
  d.materials[satin].roughness = 0.5;
  rooms::addQuad(d, {0, 0, 0.5}, {5, 0, 0}, {0, 5, 0}, satin);
  const Scene scene(d);
  Receivers r;
  for (double x : {0.6, 2.5, 4.0})
  {
    r.points.push_back({x, 2.2, 2});
    r.normals.push_back({0, 0, -1});
  }
  const Result local = solve(scene, r, settings(Method::Local, 256000));
  const Result compensated = solve(scene, r, settings(Method::Compensated, 256000));
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const double error = std::hypot(local.standardError[i], compensated.standardError[i]);
    EXPECT_LT(std::abs(local.illuminance[i] - compensated.illuminance[i]), 4.6 * error) << i;
    EXPECT_LT(error, 0.02 * local.illuminance[i]);
  }
  Camera camera;
  camera.position = {2.5, 0.5, 2};
  camera.target = {2.5, 3, 0.5};
  camera.fieldOfView = 10;
  camera.width = camera.height = 2;
  const LuminanceResult a = solveLuminance(scene, camera, settings(Method::Local, 256000));
  const LuminanceResult b = solveLuminance(scene, camera, settings(Method::Compensated, 256000));
  for (std::size_t i = 0; i < a.luminance.size(); ++i)
  {
    const double error = std::hypot(a.standardError[i], b.standardError[i]);
    EXPECT_LT(std::abs(a.luminance[i] - b.luminance[i]), 4.6 * error) << i;
    EXPECT_LT(error, 0.04 * a.luminance[i]);
  }
}

// A glossy furnace of given exitance where every surface reflects the albedo A(mu) of its direction is not uniform, but
// the energy balance holds: mean over the surfaces of absorbed = emitted. Here by the luminance of a narrow lobe: a
// mirror-like floor (roughness 0.05) shows the emitting ceiling above a black room: L = A(mu) M/pi.
TEST(Glossy, NarrowLobeShowsTheCeiling)
{
  SceneDescription d;
  const auto floor = rooms::addMaterial(d, 0), ceiling = rooms::addMaterial(d, 0, 1000);
  d.materials[floor].specular = 0.5;
  d.materials[floor].roughness = 0.05;
  rooms::addQuad(d, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, floor);
  rooms::addQuad(d, {-50, -50, 3}, {0, 100, 0}, {100, 0, 0}, ceiling);
  const Scene scene(d);
  Camera camera;
  camera.position = {0, -2, 2};
  camera.target = {0, 0, 0};
  camera.fieldOfView = 5;
  camera.width = camera.height = 2;
  const LuminanceResult image = solveLuminance(scene, camera, settings(Method::Compensated, 64000));
  const Brdf brdf(d.materials[floor], 1);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double exact = brdf.albedo(std::cos(pi / 4), uniformBands(1)) * 1000 / pi;
    EXPECT_NEAR(image.luminance[i], exact,
                4.4 * image.standardError[i] + 0.01 * exact);  // the albedo varies over 5 degrees
    EXPECT_LT(image.standardError[i], 0.02 * exact);
  }
}

namespace
{
// What a panel of 1 m, 2 m above a glossy point that is seen from `outgoing`, makes of it: pi L by quadrature, and the
// variance of one sample uniform in the panel's solid angle.
struct PanelInLobe
{
  static constexpr double exitance = 1000;
  double value = 0, variance = 0;

  PanelInLobe(const Brdf& brdf, const Vec3& outgoing)
  {
    constexpr int side = 1000;
    double solidAngle = 0, square = 0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
      {
        const Vec3 p{(i + 0.5) / side - 0.5, (j + 0.5) / side + 0.5, 2};
        const double d2 = dot(p, p), cosine = p.z / std::sqrt(d2), angle = cosine / d2 / (side * side);
        const double score = brdf.timesPi({0, 0, 1}, normalized(p), outgoing)[0] * exitance / pi * cosine;
        solidAngle += angle;
        this->value += score * angle;
        square += score * score * angle;
      }
    this->variance = square * solidAngle - this->value * this->value;
  }
};
}  // namespace

// A lobe much narrower than a luminous rectangle, wholly inside its image and on its border: the closed form by
// quadrature, and at most a third of the standard error that samples of the rectangle alone would have. |t| < 4.2 at
// four values: false alarm below 1e-3.
TEST(Glossy, NarrowLobesSeeRectanglesWithoutNoise)
{
  SceneDescription d;
  const auto floor = rooms::addMaterial(d, 0);
  d.materials[floor].specular = 0.5;
  d.materials[floor].roughness = 0.1;
  rooms::addQuad(d, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, floor);
  Luminaire panel;
  panel.position = {0, 1, 2};
  panel.sideU = {1, 0, 0};
  panel.sideV = {0, 1, 0};
  panel.flux = PanelInLobe::exitance;
  d.luminaires.push_back(panel);
  const Scene scene(d);
  Receivers r;
  for (double y : {-0.51, -1.0})
  {
    r.points.push_back({0, 0, 0});
    r.normals.push_back({0, 0, 1});
    r.brdfs.push_back(&scene.brdf(0));
    r.outgoing.push_back(normalized(Vec3{0.1, y, 2}));
    r.followsMirror.push_back(0);
  }
  for (Method method : {Method::Local, Method::Compensated})
  {
    const Result result = solve(scene, r, settings(method, 12800));
    for (std::size_t i = 0; i < r.points.size(); ++i)
    {
      const PanelInLobe exact(scene.brdf(0), r.outgoing[i]);
      EXPECT_LT(std::abs(result.illuminance[i] - exact.value), 4.2 * result.standardError[i] + 1e-4 * exact.value);
      EXPECT_LT(result.standardError[i], 0.04 * exact.value);
      EXPECT_LT(result.standardError[i], std::sqrt(exact.variance / (12800 / 4)) / 3) << i;
    }
  }
}
