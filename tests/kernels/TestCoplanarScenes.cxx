// SPDX-License-Identifier: BSD-3-Clause
// What cameras, mirrors and large scenes make of faces in one place, and what is no such face.
#include <gtest/gtest.h>

#include "Bodies.h"
#include "estimator/solve/OverlapAudit.h"

using namespace bodies;

namespace
{
double seen(const SceneDescription& d, const Vec3& from, const Vec3& target, Method method)
{
  Settings s;
  s.method = method;
  s.trajectories = 1024;
  const LuminanceResult image = solveLuminance(Scene(d), {from, target, {0, 1, 0}, 10, 2, 2}, s);
  return image.luminance[0];
}
}  // namespace

// A camera under a luminous panel of 1000 lm/m2 in a black ceiling sees 1000/pi cd/m2 by every method, in either order.
TEST(CoplanarScenes, CamerasSeeThePanel)
{
  for (const bool panelFirst : {true, false})
  {
    SceneDescription d;
    const auto black = rooms::addMaterial(d, 0), bright = rooms::addMaterial(d, 0, 1000);
    for (const bool panel : {panelFirst, !panelFirst})
      panel ? rooms::addQuad(d, {1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0}, bright)
            : rooms::addQuad(d, {0, 0, 3}, {0, 4, 0}, {4, 0, 0}, black);
    for (int method = 0; method <= static_cast<int>(Method::Direct); ++method)
      EXPECT_NEAR(seen(d, {2, 2, 0.5}, {2, 2, 3}, static_cast<Method>(method)), 1000 / pi, 1e-6) << method;
  }
}

// A luminous panel of two faces, as a double-sided one is read, is as bright from either side, turned as well.
TEST(CoplanarScenes, CamerasSeeBothSides)
{
  for (const std::uint64_t turn : {0u, 1u, 2u})
  {
    SceneDescription d;
    const auto bright = rooms::addMaterial(d, 0.5, 1000);
    rooms::addQuad(d, {1, 1, 3}, {0, 2, 0}, {2, 0, 0}, bright);
    rooms::addQuad(d, {1, 1, 3}, {2, 0, 0}, {0, 2, 0}, bright);
    Pose pose;
    if (turn > 0)
      pose.axes = randomAxes(turn);
    const SceneDescription turned = posed(d, pose);
    for (const double z : {2.0, 4.0})
      for (int method = 0; method <= static_cast<int>(Method::Direct); ++method)
        EXPECT_NEAR(seen(turned, pose(Vec3{2, 2, z}), pose(Vec3{2, 2.1, 3}), static_cast<Method>(method)), 1000 / pi,
                    1e-6)
            << "from " << z << ", method " << method;
    EXPECT_TRUE(auditOverlaps(Scene(turned)).empty());
  }
}

// A camera over a floor with a decal, partly over the floor's border: rho E / pi, E straight from the lamp.
TEST(CoplanarScenes, CamerasSeeTheDecal)
{
  SceneDescription d;
  rooms::addQuad(d, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, rooms::addMaterial(d, 0.5));
  addPanel(d, {2, 2, 0}, {0, 0, 1}, 0.7, rooms::addMaterial(d, 0.2));
  Luminaire lamp;
  lamp.position = {2, 2, 2};
  lamp.flux = 1000;
  d.luminaires.push_back(lamp);
  const double e = 1000 / pi / 4;  // lx under the lamp
  for (const Method method : {Method::Local, Method::Compensated, Method::Gathered})
  {
    EXPECT_NEAR(seen(d, {2, 2, 1.5}, {2, 2, 0}, method), 0.2 * e / pi, 0.02 * e / pi);
    const double beside = e * std::pow(4 / (4 + 1.0), 2);  // 1 m off: cos^4
    EXPECT_NEAR(seen(d, {3, 2, 1.5}, {3, 2, 0}, method), 0.5 * beside / pi, 0.03 * e / pi);
  }
}

// A lamp in a mirror, half of which a black sheet covers, from in front and, back to back with another, from behind.
TEST(CoplanarScenes, MirrorsAreCovered)
{
  SceneDescription d;
  Material mirror;
  mirror.mirror = 0.8;
  d.materials.push_back(mirror);
  rooms::addQuad(d, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0);
  rooms::addQuad(d, {0, -2, 0}, {2, 0, 0}, {0, 4, 0}, rooms::addMaterial(d, 0));
  rooms::addQuad(d, {-2, -2, 0}, {0, 4, 0}, {4, 0, 0}, 1);  // looks down
  Luminaire lamp;
  lamp.distribution = Distribution::Isotropic;
  lamp.flux = 1000;
  for (const double z : {1.0, -1.0})
  {
    lamp.position = {0, 0.2, z};
    d.luminaires.push_back(lamp);
  }
  Receivers r;
  for (const Vec3& p : {Vec3{-1, 0.2, 1}, Vec3{1, 0.2, 1}, Vec3{-1, 0.2, -1}})
  {
    r.points.push_back(p);
    r.normals.push_back({0, 0, p.z > 0 ? -1.0 : 1.0});
  }
  for (const Method method : {Method::Local, Method::Compensated, Method::Gathered})
  {
    Settings s;
    s.method = method;
    s.trajectories = 4096;
    const Result result = solve(Scene(d), r, s);
    const double image = 0.8 * 1000 / (4 * pi) * 2 / std::pow(1 + 4, 1.5);
    EXPECT_NEAR(result.illuminance[0], image, 1e-6 * image);
    EXPECT_NEAR(result.illuminance[1], 0, 1e-9);
    EXPECT_NEAR(result.illuminance[2], 0, 1e-9);
  }
}

// A panel of 1000 lm/m2 and a later one of 400 lm/m2 partly over it, and twice the same panel: what is covered does not
// shine, neither in closed form nor by trajectories.
TEST(CoplanarScenes, CoveredLightDoesNotShine)
{
  constexpr int steps = 400;
  SceneDescription d;
  const auto bright = rooms::addMaterial(d, 0, 1000), dim = rooms::addMaterial(d, 0, 400);
  rooms::addQuad(d, {1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0}, bright);
  rooms::addQuad(d, {1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0}, bright);
  rooms::addQuad(d, {2.2, 1.8, 3}, {0, 0.4, 0}, {0.8, 0, 0}, dim);
  Receivers r;
  r.points = {{2, 2, 0}, {3, 1.5, 1}};
  r.normals = {{0, 0, 1}, {0, 0, 1}};
  for (const Method method : {Method::Compensated, Method::Gathered, Method::Local, Method::Direct})
  {
    Settings s;
    s.method = method;
    s.trajectories = method == Method::Direct ? 1 << 20 : 1024;
    s.epsilon = 0.2;
    const Result result = solve(Scene(d), r, s);
    for (std::size_t i = 0; i < r.points.size(); ++i)
    {
      double truth = 0;
      for (int j = 0; j < steps; ++j)
        for (int k = 0; k < steps; ++k)
        {
          const double x = 1.5 + 1.5 * (j + 0.5) / steps, y = 1.5 + (k + 0.5) / steps;
          const bool over = x > 2.2 && std::abs(y - 2) < 0.2;
          const double height = 3 - r.points[i].z, m = over ? 400 : x < 2.5 ? 1000 : 0;
          const double d2 = std::pow(x - r.points[i].x, 2) + std::pow(y - r.points[i].y, 2) + height * height;
          truth += m / pi * height * height / (d2 * d2) * 1.5 / (steps * steps);
        }
      EXPECT_NEAR(result.illuminance[i], truth, 5 * result.standardError[i] + 2e-3 * truth) << static_cast<int>(method);
      EXPECT_LT(result.standardError[i], 0.02 * truth);
    }
  }
}

// What stands on a floor encloses its side of it: no warning. Neighbours, edges, one material and layers that are told
// apart are no overlap.
TEST(CoplanarScenes, OrdinaryRoomsHaveNone)
{
  SceneDescription d;
  const auto grey = rooms::addMaterial(d, 0.5), white = rooms::addMaterial(d, 0.9);
  rooms::addQuad(d, {0, 0, 0}, {2, 0, 0}, {0, 4, 0}, grey);
  rooms::addQuad(d, {2, 0, 0}, {2, 0, 0}, {0, 4, 0}, white);     // beside it
  rooms::addQuad(d, {0, 0, 0}, {0, 4, 0}, {0, 0, 3}, white);     // a wall
  rooms::addQuad(d, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, grey);      // of one material
  rooms::addQuad(d, {0, 0, 1e-4}, {1, 0, 0}, {0, 1, 0}, white);  // a tenth of a millimetre up
  rooms::addQuad(d, {4, 0, 0}, {1, 0, 0.001}, {0, 4, 0}, grey);  // a slight slope
  for (const std::uint64_t turn : {0u, 1u, 2u})
  {
    Pose pose;
    if (turn > 0)
      pose.axes = randomAxes(turn);
    EXPECT_TRUE(Scene(posed(d, pose)).overlaps().empty()) << turn;
  }
  d.surfaceNames = {"floor", "box"};
  d.triangleSurface.assign(d.triangles.size(), 0);
  rooms::addBox(d, {0.5, 2.5, 0}, {1, 1, 1}, white, false);
  d.triangleSurface.resize(d.triangles.size(), 1);
  const Scene standing(d);
  const std::vector<AuditLine> lines = auditOverlaps(standing);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].subject, "overlapping faces");
  EXPECT_NE(lines[0].choice.find("surface floor (reflectance 0.5) lie back to back over 1 m2"), std::string::npos)
      << lines[0].choice;
}

// Of many pairs of materials the largest are named, the others counted.
TEST(CoplanarScenes, ManyPairsAreCounted)
{
  SceneDescription d;
  rooms::addQuad(d, {0, 0, 0}, {20, 0, 0}, {0, 20, 0}, rooms::addMaterial(d, 0.5));
  for (int i = 0; i < 12; ++i)
    rooms::addQuad(d, {1.5 * i, 1, 0}, {1, 0, 0}, {0, 1.0 + i, 0}, rooms::addMaterial(d, 0.01 * i));
  const std::vector<AuditLine> lines = auditOverlaps(Scene(d));
  ASSERT_EQ(lines.size(), 9u);
  EXPECT_NE(lines[0].choice.find("over 12 m2"), std::string::npos) << lines[0].choice;
  EXPECT_NE(lines[8].choice.find("4 further pairs of materials lie in one plane over 10 m2"), std::string::npos)
      << lines[8].choice;
}
