// SPDX-License-Identifier: BSD-3-Clause
// Glossy surfaces and mirrors in whole scenes.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/LuminanceImage.h"
#include "estimator/Solver.h"
#include "geometry/Polygon.h"

using namespace kalos;

static Settings settings(Method method, long long trajectories)
{
  Settings s;
  s.method = method;
  s.trajectories = trajectories;
  return s;
}

// An emitting patch behind a black screen, seen from the floor only in a wall mirror: E = m M F(mirror image of the
// patch).
static SceneDescription mirrorScene()
{
  SceneDescription d;
  const auto black = rooms::addMaterial(d, 0), mirror = rooms::addMaterial(d, 0),
             patch = rooms::addMaterial(d, 0, 1000);
  d.materials[mirror].mirror = 0.8;
  rooms::addQuad(d, {0, -5, -5}, {0, 10, 0}, {0, 0, 10}, mirror);    // the plane x = 0
  rooms::addQuad(d, {1, -0.5, 2}, {0, 0, 1}, {0, 1, 0}, patch);      // looks towards -x
  rooms::addQuad(d, {1.01, -5, 1.5}, {4, 0, 0}, {0, 10, 0}, black);  // between the patch and what lies right and below
  return d;
}

TEST(Mirror, LightThatComesByAMirrorIsGathered)
{
  const Scene scene(mirrorScene());
  Receivers r;
  for (double x : {1.2, 2.0, 3.0})
  {
    r.points.push_back({x, 0.2, 0});
    r.normals.push_back({0, 0, 1});
  }
  const Result result = solve(scene, r, settings(Method::Compensated, 1280000));
  const Vec3 image[4] = {{-1, -0.5, 2}, {-1, 0.5, 2}, {-1, 0.5, 3}, {-1, -0.5, 3}};
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const double exact = 0.8 * 1000 * polygonFormFactor(r.points[i], r.normals[i], image, 4);
    EXPECT_GT(exact, 1);
    EXPECT_LT(std::abs(result.illuminance[i] - exact), 4.2 * result.standardError[i]);  // false alarm below 1e-3
    EXPECT_LT(result.standardError[i], 0.05 * exact);
  }
}

// A point luminaire in front of a mirror: its image at (-1, 0, 2.5) adds m I cos / d^2 in closed form, also as part of
// what a diffuse wall reflects: E behind the screen comes by the mirror alone.
TEST(Mirror, PointLuminairesHaveImages)
{
  SceneDescription d = mirrorScene();
  d.materials[2].exitance = {};
  Luminaire lamp;
  lamp.position = {1, 0, 3.5};
  lamp.flux = 4000;
  lamp.distribution = Distribution::Isotropic;
  d.luminaires.push_back(lamp);
  const Scene scene(d);
  Receivers r;
  for (double x : {1.2, 2.0})
  {
    r.points.push_back({x, 0.2, 0});
    r.normals.push_back({0, 0, 1});
  }
  const Result result = solve(scene, r, settings(Method::Compensated, 3200));
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const Vec3 way = Vec3{-1, 0, 3.5} - r.points[i];
    const double d2 = dot(way, way), exact = 0.8 * 4000 / (4 * pi) * way.z / (d2 * std::sqrt(d2));
    EXPECT_NEAR(result.illuminance[i], exact, 1e-9);
  }
}

// Light that reaches a diffuse floor by a mirror, and then a shaded receiver: two methods, one truth. |t| < 4.4.
TEST(Mirror, CausticsAreReflectedWithoutBias)
{
  SceneDescription d = mirrorScene();
  d.materials[2].exitance = {};
  rooms::addQuad(d, {0, -5, 0}, {5, 0, 0}, {0, 10, 0}, rooms::addMaterial(d, 0.7));
  rooms::addQuad(d, {5, -5, 0}, {0, 0, 5}, {0, 10, 0}, rooms::addMaterial(d, 0.7));
  Luminaire lamp;
  lamp.position = {1, 0, 3.5};
  lamp.flux = 4000;
  lamp.distribution = Distribution::Isotropic;
  d.luminaires.push_back(lamp);
  const Scene scene(d);
  Receivers r;
  for (double x : {1.5, 3.5})
  {
    r.points.push_back({x, 0.2, 1});
    r.normals.push_back({1, 0, 0});  // away from the mirror, which local estimation does not see
  }
  const Result local = solve(scene, r, settings(Method::Local, 2560000));
  const Result compensated = solve(scene, r, settings(Method::Compensated, 2560000));
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const double error = std::hypot(local.standardError[i], compensated.standardError[i]);
    EXPECT_LT(std::abs(local.illuminance[i] - compensated.illuminance[i]), 4.4 * error);
    EXPECT_LT(error, 0.03 * local.illuminance[i]);
  }
}

// A camera that looks into the mirror sees the patch at m M/pi, and a luminous rectangle too.
TEST(Mirror, ImagesFollowMirrors)
{
  SceneDescription d = mirrorScene();
  Luminaire panel;
  panel.position = {1, 2, 2.5};
  panel.axis = {-1, 0, 0};
  panel.sideU = {0, 0.5, 0};
  panel.sideV = {0, 0, 0.5};
  panel.flux = 250;
  d.luminaires.push_back(panel);
  const Scene scene(d);
  Camera camera;
  camera.position = {3, 1.5, 2.5};
  camera.target = {0, 0.375, 2.5};  // towards the patch's image at (-1, 0, 2.5)
  camera.fieldOfView = 4;
  camera.width = camera.height = 3;
  EXPECT_NEAR(solveLuminance(scene, camera, settings(Method::Compensated, 320)).luminance[4], 0.8 * 1000 / pi, 1e-9);
  camera.target = {0, 1.875, 2.5};  // towards the panel's image at (-1, 2, 2.5)
  EXPECT_NEAR(solveLuminance(scene, camera, settings(Method::Compensated, 320)).luminance[4], 0.8 * 1000 / pi, 1e-9);
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
