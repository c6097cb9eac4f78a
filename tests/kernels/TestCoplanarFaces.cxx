// SPDX-License-Identifier: BSD-3-Clause
// Faces of two materials in one place: one rule, whatever the method, the order, the pose and the mesh. The truths are
// integrals over what lies on top, by the midpoint rule.
#include <gtest/gtest.h>

#include <functional>

#include "Poses.h"
#include "Student.h"
#include "estimator/solve/OverlapAudit.h"

using namespace poses;

namespace
{
constexpr int steps = 200;

// lx at p from a Lambertian plane z = 0, x and y from `low` to `high`, of the given reflectance and lit by a lamp.
double fromPlane(const Vec3& p, const Vec3& n, double low, double high, const Luminaire& lamp,
                 const std::function<double(double, double)>& reflectance)
{
  double sum = 0;
  const double side = (high - low) / steps;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
    {
      const Vec3 y{low + (i + 0.5) * side, low + (j + 0.5) * side, 0}, in = y - lamp.position, out = p - y;
      const double e = intensity(lamp, normalized(in)) * lamp.position.z / std::pow(length(in), 3);
      const double g = std::max(0.0, out.z) * std::max(0.0, -dot(out, n)) / std::pow(dot(out, out), 2);
      sum += reflectance(y.x, y.y) / pi * e * g * side * side;
    }
  return sum;
}

struct Case
{
  SceneDescription scene;
  Receivers receivers;
  std::vector<double> truth;  // lx, at each receiver
  std::size_t warnings = 1;

  void expect(const Vec3& p, const Vec3& n, double lux)
  {
    this->receivers.points.push_back(p);
    this->receivers.normals.push_back(n);
    this->truth.push_back(lux);
  }
};

Luminaire lampOverFloor()
{
  Luminaire lamp;
  lamp.position = {2, 2, 2};
  lamp.flux = 1000;
  return lamp;
}

// A carpet of reflectance 0.9, 2 m x 2 m, on a floor of 0.5; the later one lies on top. `pieces` cuts the carpet up.
Case carpet(bool carpetLater, int pieces)
{
  Case c;
  c.scene.luminaires = {lampOverFloor()};
  const auto grey = rooms::addMaterial(c.scene, 0.5), white = rooms::addMaterial(c.scene, 0.9);
  const auto layFloor = [&] { rooms::addQuad(c.scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, grey); };
  if (carpetLater)
    layFloor();
  const double side = 2.0 / pieces;
  for (int i = 0; i < pieces; ++i)
    for (int j = 0; j < pieces; ++j)
      rooms::addQuad(c.scene, {1 + i * side, 1 + j * side, 0}, {side, 0, 0}, {0, side, 0}, white);
  if (!carpetLater)
    layFloor();
  for (const Vec3& p : {Vec3{2, 2, 1}, Vec3{0.6, 2.2, 0.7}})
    c.expect(p, {0, 0, -1}, fromPlane(p, {0, 0, -1}, 0, 4, c.scene.luminaires[0], [&](double x, double y) {
               return carpetLater && std::max(std::abs(x - 2), std::abs(y - 2)) < 1 ? 0.9 : 0.5;
             }));
  return c;
}

// Half over the floor's border, and turned by 30 degrees.
Case turnedCarpet()
{
  Case c;
  c.scene.luminaires = {lampOverFloor()};
  const auto grey = rooms::addMaterial(c.scene, 0.5), white = rooms::addMaterial(c.scene, 0.9);
  rooms::addQuad(c.scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, grey);
  const double cosine = std::cos(pi / 6), sine = 0.5;
  rooms::addQuad(c.scene, {2, 1, 0}, {3 * cosine, 3 * sine, 0}, {-2 * sine, 2 * cosine, 0}, white);
  const Vec3 p{2.5, 2, 1}, n = normalized({0.3, 0, -1});
  c.expect(p, n, fromPlane(p, n, -1, 7, c.scene.luminaires[0], [&](double x, double y) {
             const double u = cosine * (x - 2) + sine * (y - 1), v = cosine * (y - 1) - sine * (x - 2);
             if (u > 0 && u < 3 && v > 0 && v < 2)
               return 0.9;
             return std::min(x, y) > 0 && std::max(x, y) < 4 ? 0.5 : 0;
           }));
  return c;
}

// A white face that looks up and a black one that looks down, lit from both sides.
Case backToBack(bool whiteFirst)
{
  Case c;
  const auto white = rooms::addMaterial(c.scene, 0.9), black = rooms::addMaterial(c.scene, 0);
  const auto layUpper = [&] { rooms::addQuad(c.scene, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, white); };
  if (whiteFirst)
    layUpper();
  rooms::addQuad(c.scene, {-5, -5, 0}, {0, 10, 0}, {10, 0, 0}, black);
  if (!whiteFirst)
    layUpper();
  Luminaire lamp;
  lamp.distribution = Distribution::Isotropic;
  lamp.flux = 1000;
  for (const double z : {2.0, -2.0})
  {
    lamp.position = {0, 0, z};
    c.scene.luminaires.push_back(lamp);
  }
  c.expect({0, 0, 1}, {0, 0, -1},
           fromPlane({0, 0, 1}, {0, 0, -1}, -5, 5, c.scene.luminaires[0], [](double, double) { return 0.9; }));
  c.expect({0, 0, -1}, {0, 0, 1}, 0);
  return c;
}

// A luminous panel of 1 m x 1 m, 1000 lm/m2, in a black ceiling 3 m up, listed before or after it.
Case panelInCeiling(bool panelFirst)
{
  Case c;
  const auto black = rooms::addMaterial(c.scene, 0), bright = rooms::addMaterial(c.scene, 0, 1000);
  const auto lay = [&](bool panel) {
    panel ? rooms::addQuad(c.scene, {1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0}, bright)
          : rooms::addQuad(c.scene, {0, 0, 3}, {0, 4, 0}, {4, 0, 0}, black);
  };
  lay(panelFirst);
  lay(!panelFirst);
  rooms::addQuad(c.scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, black);
  c.expect({2, 2, 0}, {0, 0, 1}, 34.1092);  // four corners of 0.5 m x 0.5 m, 3 m away
  return c;
}

const std::map<std::string, std::function<Case()>>& cases()
{
  static const std::map<std::string, std::function<Case()>> all{
      {"carpet", [] { return carpet(true, 1); }},
      {"carpet_of_200_triangles", [] { return carpet(true, 10); }},
      {"floor_over_carpet", [] { return carpet(false, 1); }},
      {"turned_carpet", turnedCarpet},
      {"back_to_back", [] { return backToBack(true); }},
      {"back_to_back_turned_round", [] { return backToBack(false); }},
      {"panel_before_ceiling", [] { return panelInCeiling(true); }},
      {"panel_after_ceiling", [] { return panelInCeiling(false); }}};
  return all;
}

// Coordinates as files in single precision hold them.
void roundCoordinates(SceneDescription& d)
{
  for (Vec3& p : d.points)
    p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

class EachOverlap : public testing::TestWithParam<std::string>
{
};

Pose poseOf(std::uint64_t number)
{
  Pose pose;
  if (number > 0)
    pose.axes = randomAxes(number);
  pose.mirror = number == 2;
  pose.scale = number == 3 ? 1000 : number == 4 ? 0.01 : 1;
  return pose;
}
}  // namespace

// Seven methods, five poses, one or two receivers: one false alarm in a thousand seeds for each case.
TEST_P(EachOverlap, HasOneTruth)
{
  const Case c = cases().at(GetParam())();
  for (std::uint64_t number = 0; number < 5; ++number)
  {
    const Pose pose = poseOf(number);
    SceneDescription d = posed(c.scene, pose);
    if (number > 0)
      roundCoordinates(d);
    const Scene scene(d);
    for (const Method method : {Method::Local, Method::SpherePublished, Method::SphereExact, Method::Disc,
                                Method::Clamped, Method::Compensated, Method::Gathered})
    {
      Settings s;
      s.method = method;
      s.trajectories = 32768;
      s.delta = s.epsilon = 0.01 * pose.scale;
      const Result result = solve(scene, posed(c.receivers, pose), s);
      for (std::size_t i = 0; i < c.truth.size(); ++i)
      {
        const bool panel = GetParam().find("panel") == 0;  // its light is all direct, and does not fall with the scale
        const double factor = panel ? 1 : pose.scale * pose.scale;
        const double reflected = factor * (result.illuminance[i] - (panel ? 0 : result.direct[i]));
        const double error = factor * result.standardError[i];
        EXPECT_NEAR(reflected, c.truth[i], allowed(result, 70) * error + 2e-4 * c.truth[i] + 1e-9)
            << "pose " << number << ", method " << static_cast<int>(method) << ", receiver " << i;
        EXPECT_LT(error, 0.02 * c.truth[i] + 1e-9);
      }
    }
  }
}

// Both faces, their materials and the area are told, and a warning is given where one hides the other.
TEST_P(EachOverlap, IsTold)
{
  const Case c = cases().at(GetParam())();
  const std::vector<AuditLine> lines = auditOverlaps(Scene(c.scene));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].subject, "warning");
  const std::string area = GetParam().find("panel") == 0   ? "over 1 m2"
                           : GetParam().find("back") == 0  ? "over 100 m2"
                           : GetParam() == "turned_carpet" ? "over 5.52479 m2"
                                                           : "over 4 m2";
  EXPECT_NE(lines[0].choice.find(area), std::string::npos) << lines[0].choice;
  EXPECT_NE(lines[0].choice.find("reflectance 0"), std::string::npos) << lines[0].choice;
}

INSTANTIATE_TEST_SUITE_P(CoplanarFaces, EachOverlap, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& [name, make] : cases())
                             names.push_back(name);
                           return names;
                         }()),
                         [](const auto& instance) { return instance.param; });
