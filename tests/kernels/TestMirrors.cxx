// SPDX-License-Identifier: BSD-3-Clause
// Mirrors in whole scenes.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "Student.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/quantities/LuminanceImage.h"
#include "estimator/solve/Solver.h"
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
  const Result result = solve(scene, r, settings(Method::Compensated, 2560000));
  const Vec3 image[4] = {{-1, -0.5, 2}, {-1, 0.5, 2}, {-1, 0.5, 3}, {-1, -0.5, 3}};
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    const double exact = 0.8 * 1000 * polygonFormFactor(r.points[i], r.normals[i], image, 4);
    EXPECT_GT(exact, 1);
    EXPECT_LT(std::abs(result.illuminance[i] - exact), allowed(result, 3) * result.standardError[i]);
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

namespace
{
Luminaire isotropic(const Vec3& position, double flux)
{
  Luminaire lamp;
  lamp.position = position;
  lamp.flux = flux;
  lamp.distribution = Distribution::Isotropic;
  return lamp;
}

// E at r with normal +z of a source of 4000 lm at p, weakened by m.
double fromImage(const Vec3& r, const Vec3& p, double m)
{
  const Vec3 way = p - r;
  const double d2 = dot(way, way);
  return m * 4000 / (4 * pi) * way.z / (d2 * std::sqrt(d2));
}

const AuditLine& mirrorLine(const Result& result)
{
  return *std::find_if(result.audit.begin(), result.audit.end(),
                       [](const AuditLine& line) { return line.subject == "point luminaires in mirrors"; });
}
}  // namespace

// Two mirrors at a right angle show a lamp three times: the third image comes by both mirrors, in one order or the
// other.
TEST(Mirror, PerpendicularMirrorsMakeThreeImages)
{
  SceneDescription d;
  for (double m : {0.8, 0.9})
    d.materials[rooms::addMaterial(d, 0)].mirror = m;
  rooms::addQuad(d, {0, 0, -10}, {0, 20, 0}, {0, 0, 20}, 0);  // x = 0
  rooms::addQuad(d, {0, 0, -10}, {20, 0, 0}, {0, 0, 20}, 1);  // y = 0
  d.luminaires.push_back(isotropic({1, 1.5, 2}, 4000));
  const Scene scene(d);
  Receivers r;
  r.points = {{2, 1, 0}, {1, 3, 0.5}, {0.2, 0.1, 0}};
  r.normals.assign(3, {0, 0, 1});
  for (Method method : {Method::Compensated, Method::Local})
  {
    const Result result = solve(scene, r, settings(method, 320));
    for (std::size_t i = 0; i < r.points.size(); ++i)
    {
      const double exact = fromImage(r.points[i], {1, 1.5, 2}, 1) + fromImage(r.points[i], {-1, 1.5, 2}, 0.8) +
                           fromImage(r.points[i], {1, -1.5, 2}, 0.9) + fromImage(r.points[i], {-1, -1.5, 2}, 0.72);
      EXPECT_NEAR(result.illuminance[i], exact, 1e-9) << i;
    }
  }
}

// A box of six mirrors has more images than are followed: no value is trusted, and a warning says so.
TEST(Mirror, ImagesThatAreLeftOutAreNotTrusted)
{
  SceneDescription d;
  d.materials[rooms::addMaterial(d, 0)].mirror = 0.7;
  rooms::addBox(d, {0, 0, 0}, {4, 3, 2}, 0, true);
  d.luminaires.push_back(isotropic({1, 1.5, 1.2}, 4000));
  Receivers r;
  r.points = {{3, 1, 0.5}};
  r.normals = {{0, 0, 1}};
  for (Method method : {Method::Compensated, Method::Gathered, Method::Local, Method::Disc, Method::Paths})
  {
    const Result result = solve(Scene(d), r, settings(method, 320));
    EXPECT_EQ(result.trusted[0], 0);
    EXPECT_TRUE(std::any_of(result.audit.begin(), result.audit.end(), [](const AuditLine& line) {
      return line.subject == "warning" && line.choice.find("more than 4096 images") != std::string::npos;
    }));
  }
}

// Mirrors at x = 0 and 3 that face each other: a series of images at 6 k +- 1, weakened by 0.8 at each reflection.
TEST(Mirror, FacingMirrorsMakeASeriesOfImages)
{
  SceneDescription d;
  d.materials[rooms::addMaterial(d, 0)].mirror = 0.8;
  rooms::addQuad(d, {0, -50, -50}, {0, 100, 0}, {0, 0, 100}, 0);
  rooms::addQuad(d, {3, -50, -50}, {0, 100, 0}, {0, 0, 100}, 0);
  d.luminaires.push_back(isotropic({1, 0, 2}, 4000));
  const Scene scene(d);
  Receivers r;
  r.points = {{2, 1, 0}};
  r.normals = {{0, 0, 1}};
  const Result result = solve(scene, r, settings(Method::Compensated, 320));
  double exact = fromImage(r.points[0], {1, 0, 2}, 1);
  for (int first : {0, 1})  // the mirror that the light meets last
  {
    Vec3 image{1, 0, 2};
    double m = 0.8;
    for (int k = 1; k < 200; ++k, m *= 0.8)
    {
      image.x = (k + first) % 2 ? -image.x : 6 - image.x;
      exact += fromImage(r.points[0], image, m);
    }
  }
  EXPECT_NEAR(result.illuminance[0], exact, 1e-6 * exact);  // 0.8^42 < 1e-4 is where the chains end
  EXPECT_GT(exact, 1.5 * fromImage(r.points[0], {1, 0, 2}, 1));
  EXPECT_NE(mirrorLine(result).reason.find("at most 0.0085 %"), std::string::npos) << mirrorLine(result).reason;
}

// Light that reaches a diffuse floor by a mirror, and then a shaded receiver: two methods, one truth.
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
    EXPECT_LT(std::abs(local.illuminance[i] - compensated.illuminance[i]), allowed(local, compensated, 2) * error);
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
