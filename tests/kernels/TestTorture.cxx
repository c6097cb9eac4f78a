// SPDX-License-Identifier: BSD-3-Clause
// Geometry that breaks ray tracers: leaks at shared vertices and edges, needles, sizes from a millimetre to ten
// kilometres in one scene, places far from the origin, flat scenes, faces that lie in one another.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "Student.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Solver.h"
#include "sampling/Warp.h"

using namespace kalos;

namespace
{
// A closed sphere of 2 rings x 2 columns triangles, normals inwards, about `centre`, squeezed along z.
SceneDescription ball(const Vec3& centre, double radius, int rings, int columns, double squeeze = 1)
{
  SceneDescription d;
  const auto material = rooms::addMaterial(d, 0.5, 125);
  auto at = [&](int ring, int column) -> std::uint32_t {
    return ring == 0 ? 0 : ring == rings ? 1 : static_cast<std::uint32_t>(2 + (ring - 1) * columns + column % columns);
  };
  d.points = {centre + Vec3{0, 0, squeeze * radius}, centre - Vec3{0, 0, squeeze * radius}};
  for (int i = 1; i < rings; ++i)
    for (int k = 0; k < columns; ++k)
    {
      const double theta = pi * i / rings, phi = 2 * pi * (k + 0.1 * i) / columns;
      d.points.push_back(centre + radius * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                                squeeze * std::cos(theta)});
    }
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < columns; ++k)
    {
      if (i + 1 < rings)
        d.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
      if (i > 0)
        d.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
    }
  d.triangleMaterial.assign(d.triangles.size(), material);
  return d;
}

// Rays from within that aim at vertices and at points of edges; those that get out.
int leaks(const SceneDescription& description, int count)
{
  const Scene scene(description);
  RandomStream random(11, 0, Purpose::Selection, 0);
  auto any = [&](std::size_t n) { return static_cast<std::size_t>(random.next() * static_cast<double>(n)); };
  int escaped = 0;
  for (int i = 0; i < count; ++i)
  {
    const auto t = static_cast<std::uint32_t>(any(scene.data().triangles.size()));
    const int corner = static_cast<int>(any(3));
    const double share = i % 2 ? 0 : random.next();
    const Vec3 target = (1 - share) * scene.corner(t, corner) + share * scene.corner(t, (corner + 1) % 3);
    const auto from = static_cast<std::uint32_t>(any(scene.data().triangles.size()));
    const double b1 = 0.2 + 0.3 * random.next(), b2 = 0.3;
    const Vec3 start = scene.corner(from, 0) + b1 * (scene.corner(from, 1) - scene.corner(from, 0)) +
                       b2 * (scene.corner(from, 2) - scene.corner(from, 0));
    if (dot(target - start, scene.normal(from)) > 1e-3 * length(target - start))
      escaped += !scene.trace(scene.anchor(start, scene.normal(from)), normalized(target - start)).valid;
  }
  return escaped;
}

// Illuminance of a white furnace of 250 lx at receivers in the middle of some of its triangles.
void expectFurnace(const SceneDescription& description, long long trajectories, const char* what)
{
  const Scene scene(description);
  Receivers r;
  for (std::size_t t = 0; t < scene.data().triangles.size(); t += 1 + scene.data().triangles.size() / 8)
  {
    const auto i = static_cast<std::uint32_t>(t);
    r.points.push_back((1.0 / 3) * (scene.corner(i, 0) + scene.corner(i, 1) + scene.corner(i, 2)) + scene.origin());
    r.normals.push_back(scene.normal(i));
  }
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.trajectories = trajectories;
  const Result result = solve(scene, r, s);
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    EXPECT_LT(std::abs(result.illuminance[i] - 250), allowed(result, 40) * result.standardError[i] + 1e-3)
        << what << ", receiver " << i << ": " << result.illuminance[i] - 250 << " +- " << result.standardError[i];
    EXPECT_LT(result.standardError[i], 0.03 * 250) << what << ", receiver " << i;
  }
  for (const AuditLine& line : result.audit)
    EXPECT_NE(line.subject, "warning") << what << ": " << line.choice;
}
}  // namespace

// Below 2e-5 of the rays that aim at nothing else: at most 3 of 200 000 a mesh.
TEST(Torture, SharedVerticesAndEdgesDoNotLeak)
{
  for (const double radius : {1e-3, 1.0, 1e4})
    for (const Vec3& centre : {Vec3{}, Vec3{1e6, -2e6, 1e6}})
    {
      const int escaped = leaks(ball(radius < 1 ? Vec3{} : centre, radius, 12, 24), 200000);
      std::printf("radius %g m, %g km away: %d of 200000 leaked\n", radius, length(centre) / 1000, escaped);
      EXPECT_LE(escaped, 3) << "radius " << radius;
    }
  EXPECT_LE(leaks(ball({}, 1, 6, 2000), 200000), 3) << "needles at the poles";
  EXPECT_LE(leaks(ball({}, 1, 12, 24, 1e-3), 200000), 3) << "a lens of 2 mm by 2 m";
}

TEST(Torture, FurnaceOfNeedles)
{
  expectFurnace(ball({}, 1, 4, 1500), 32000, "needles");
}

TEST(Torture, FurnaceAThousandKilometresAway)
{
  SceneDescription d;
  const auto white = rooms::addMaterial(d, 0.6, 100);
  rooms::addBox(d, {0, 0, 0}, {5, 5, 5}, white, true);
  rooms::addBox(d, {1, 1, 0.5}, {1.2, 1.4, 1.5}, white, false);
  rooms::translate(d, {1e6, -2e6, 5e5});
  expectFurnace(d, 64000, "far away");
}

// A closed hall of 10 km x 10 km x 3 m: the light of a spot stays about it.
TEST(Torture, FurnaceOfTenKilometresByThreeMetres)
{
  SceneDescription d;
  rooms::addBox(d, {0, 0, 0}, {1e4, 1e4, 3}, rooms::addMaterial(d, 0.6, 100), true);
  expectFurnace(d, 64000, "flat");
}

// Boxes of 1 mm and a room of 5 m in a shell of 10 km, all of one luminance.
TEST(Torture, FurnaceOfMillimetresInTenKilometres)
{
  SceneDescription d;
  const auto white = rooms::addMaterial(d, 0.6, 100);
  rooms::addBox(d, {-5e3, -5e3, -5e3}, {1e4, 1e4, 1e4}, white, true);
  rooms::addBox(d, {0, 0, 0}, {5, 5, 5}, white, false);
  expectFurnace(d, 64000, "small in large");
}

// A floor that lies in the floor: reflectors one in the other are one reflector. Independent seeds, 3 points, |t|
// < 4.4.
TEST(Torture, CoplanarFacesAreOne)
{
  SceneDescription once = rooms::litRoom(0.6), twice = once;
  rooms::addQuad(twice, {0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 0);
  rooms::addQuad(twice, {1, 1, 0}, {0, 2, 0}, {2, 0, 0}, 0);
  Receivers r;
  for (const double x : {0.5, 2.0, 4.0})
  {
    r.points.push_back({x, 2, 0});
    r.normals.push_back({0, 0, 1});
  }
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.trajectories = 64000;
  const Result a = solve(Scene(once), r, s);
  s.seed = 2;
  const Result b = solve(Scene(twice), r, s);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double error = std::hypot(a.standardError[i], b.standardError[i]);
    EXPECT_LT(std::abs(a.illuminance[i] - b.illuminance[i]), 4.4 * error) << i;
    EXPECT_LT(error, 0.02 * a.illuminance[i]);
  }
}
