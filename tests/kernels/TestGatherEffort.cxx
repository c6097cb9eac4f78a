// SPDX-License-Identifier: BSD-3-Clause
// Only receivers with a surface near send gather rays; the means do not change.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "Student.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/solve/Solver.h"
#include "sampling/Random.h"
#include "sampling/Warp.h"

using namespace kalos;

namespace
{
void add(Receivers& r, const Vec3& p, const Vec3& n)
{
  r.points.push_back(p);
  r.normals.push_back(n);
}

/// Eight receivers near an edge, a corner, a contact or a wall in free space, then six far from all; so many times.
Receivers nearAndFar(int times = 1)
{
  Receivers r;
  if (times > 1)
    r = nearAndFar(times - 1);
  for (double h : {1e-3, 0.1})
  {
    add(r, {h, 2.5, 0}, {0, 0, 1});
    add(r, {5, h, h}, {-1, 0, 0});
    add(r, {2.2 + h, 1.5, 0}, {0, 0, 1});
    add(r, {5 - h, 4.2, 2}, {0, 0, 1});
  }
  add(r, {2.5, 2.5, 5}, {0, 0, -1});
  add(r, {0, 2.5, 3.3}, {1, 0, 0});
  add(r, {5, 1.4, 2.5}, {-1, 0, 0});
  add(r, {1.6, 1.7, 1.5}, {0, 0, 1});
  add(r, {1.5, 3.5, 5}, {0, 0, -1});
  add(r, {2.5, 2.5, 3.5}, {0, 0, 1});
  return r;
}

std::string gatheringReceivers(const Result& result)
{
  for (const AuditLine& line : result.audit)
    if (line.subject == "gather rays")
      return line.choice;
  return {};
}

Settings settings(bool everywhere, std::uint64_t seed, long long trajectories = 65536)
{
  Settings s;
  s.disabled = {Technique::Paths};  // in furnaces, too
  if (everywhere)
    s.disabled.insert(Technique::Near);
  s.trajectories = trajectories;
  s.seed = seed;
  return s;
}
}  // namespace

// As many rays as for many receivers: 448 receivers, fourteen places repeated; the first fourteen are tested.
// Independent runs of six seeds each: Welch's t of 84 degrees of freedom, Sidak for 28 comparisons: |t| < 4.3, false
// alarm 1e-3.
TEST(GatherEffort, SameValuesWithFewerRays)
{
  constexpr std::uint64_t seeds = 6;
  int untrusted = 0;
  for (double rho : {0.3, 0.8})
  {
    const Scene scene(rooms::furnishedRoom(rho));
    const Receivers r = nearAndFar(32);
    constexpr std::size_t count = 14;
    std::vector<double> difference(count), sparing(count), all(count);  // of the means
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
      const Result few = solve(scene, r, settings(false, seed, 8192)),
                   many = solve(scene, r, settings(true, 100 + seed, 8192));
      EXPECT_EQ(gatheringReceivers(few), "at 256 of 448 receivers");
      EXPECT_EQ(gatheringReceivers(many), "at 448 of 448 receivers");
      for (std::size_t i = 0; i < count; ++i)
      {
        difference[i] += (few.illuminance[i] - many.illuminance[i]) / (seeds * many.illuminance[i]);
        sparing[i] += std::pow(few.standardError[i] / (seeds * many.illuminance[i]), 2);
        all[i] += std::pow(many.standardError[i] / (seeds * many.illuminance[i]), 2);
        untrusted += !few.trusted[i];
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_LT(std::abs(difference[i]), 4.3 * std::sqrt(sparing[i] + all[i])) << rho << " point " << i;
      EXPECT_LT(std::sqrt(sparing[i] + all[i]), 0.02) << rho << " point " << i;
      // Errors of 42 degrees of freedom are good to 11 %; where nothing is near, rays would take a third off the error
      // in the dim room, for more than they save.
      EXPECT_LT(std::sqrt(sparing[i]), 2 * std::sqrt(all[i])) << rho << " point " << i;
    }
  }
  // Of 168; one of 504 was, with other seeds.
  EXPECT_LE(untrusted, 3);
}

// Trajectories are shared by all receivers: where these are few, each has more gather rays for each of them, by the
// root of (1 + 128 / 14) / (1 + 128 / 448), 2.8, as a power of two.
TEST(GatherEffort, FewReceiversHaveMoreRaysPerTrajectory)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  const Receivers few = nearAndFar(), many = nearAndFar(32);
  const Settings s = settings(false, 1, 8 * 256);
  const double rays = solve(scene, few, s).gatherRays[0], ofMany = solve(scene, many, s).gatherRays[0];
  EXPECT_GT(ofMany, 0);
  EXPECT_GE(rays, 2 * ofMany);
  EXPECT_LE(rays, 4 * ofMany);
}

// An image may see no surface: then no receiver is served.
TEST(GatherEffort, NoReceiverNeedsNoRays)
{
  const Result none = solve(Scene(rooms::furnishedRoom(0.5)), {}, settings(false, 1, 64));
  EXPECT_EQ(none.trajectories, 64);
  EXPECT_TRUE(none.illuminance.empty());
  EXPECT_EQ(gatheringReceivers(none), "at 0 of 0 receivers");
  EXPECT_TRUE(std::any_of(none.audit.begin(), none.audit.end(), [](const AuditLine& line) {
    return line.reason.find("; 0 rays, 0 spared elsewhere") != std::string::npos;
  }));
}

// In the white furnace the far receivers must have the closed form too: six at each reflectance.
TEST(GatherEffort, VerticesAloneAreExactWhereNothingIsNear)
{
  for (double rho : {0.5, 0.9})
  {
    const Scene scene(rooms::furnace(rho, 250 * (1 - rho)));
    const Receivers r = nearAndFar();
    const Result result = solve(scene, r, settings(false, 3));
    for (std::size_t i = 8; i < r.points.size(); ++i)
    {
      EXPECT_LT(std::abs(result.illuminance[i] - 250), allowed(result, 12) * result.standardError[i])
          << rho << " point " << i;
      EXPECT_LT(result.standardError[i], 0.01 * 250) << rho << " point " << i;
    }
  }
}

// Only gather rays see light that comes by a mirror.
TEST(GatherEffort, MirrorsAreGatheredEverywhere)
{
  SceneDescription description = rooms::furnace(0.5, 100);
  description.materials.push_back({});
  description.materials.back().mirror = uniformBands(0.5)[0];
  rooms::addQuad(description, {2, 2, 4}, {0.5, 0, 0}, {0, 0.5, 0}, 1);
  const Result result = solve(Scene(description), nearAndFar(), settings(false, 4));
  EXPECT_EQ(gatheringReceivers(result), "at 14 of 14 receivers");
}

// Against the kernels of points that rays find, over surfaces at any angle.
TEST(GatherEffort, NoKernelIsLargeWhereAPlaceIsClear)
{
  SceneDescription description = rooms::furnace(0.5, 100);
  rooms::addQuad(description, {0, 0, 3}, {2, 0, 0.3}, {0, 5, 2}, 0);
  rooms::addQuad(description, {5, 0, 1}, {0, 5, 0}, {-2, 0, 0.5}, 0);
  const Scene scene(description);
  RandomStream random(7, 0, Purpose::Gather, 0);
  int clear = 0, nearer = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 p{5 * random.next() - 2.5, 5 * random.next() - 2.5, 5 * random.next() - 2.5};
    const Vec3 n = Frame({0, 0, i % 2 ? 1.0 : -1.0}).toWorld(cosineHemisphere(random.next(), random.next()));
    const double radius = 0.1 + random.next();
    bool near = false, large = false;
    for (int k = 0; k < 64; ++k)
    {
      const Vec3 direction = Frame(n).toWorld(cosineHemisphere(random.next(), random.next()));
      const SurfacePoint y = scene.trace(p, direction);
      if (!y.valid || length(y.position - p) >= radius)
        continue;
      near = true;
      const double squared = dot(y.position - p, y.position - p);
      // sqrt(27)/16: a wall at right angles, seen a third root of three under its normal.
      large |=
          dot(direction, n) * -dot(direction, y.normal) / squared > 1.0001 * std::sqrt(27.0) / 16 / (radius * radius);
    }
    const bool said = scene.clear(p, n, radius);
    EXPECT_FALSE(said && large) << i;
    clear += said;
    nearer += said && near;
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(nearer, 20);  // walls that lean away
  const Scene plain(rooms::furnace(0.5, 100));
  EXPECT_TRUE(plain.clear({0, 0, 2.5}, {0, 0, -1}, 2.4 - 1.5 + 0.05));
  EXPECT_FALSE(plain.clear({-2.4, 0, -2.5}, {0, 0, 1}, 0.2));
  EXPECT_TRUE(plain.clear({-2.4, 0, -2.5}, {0, 0, 1}, 0.0999));
}

namespace
{
/// A closed vault of 5 m: half a cylinder in facets that meet at 174 degrees, over a floor, between two walls.
SceneDescription vault(double reflectance, double exitance)
{
  constexpr int facets = 30;
  SceneDescription scene;
  const auto material = rooms::addMaterial(scene, reflectance, exitance);
  auto rim = [](int i, double y) {
    const double angle = pi * i / facets;
    return Vec3{2.5 * std::cos(angle), y, i % facets ? 2.5 * std::sin(angle) : 0};
  };
  for (int i = 0; i < facets; ++i)
  {
    rooms::addQuad(scene, rim(i, 0), rim(i + 1, 0) - rim(i, 0), {0, 5, 0}, material);
    for (double y : {0.0, 5.0})
    {
      const auto first = static_cast<std::uint32_t>(scene.points.size());
      for (const Vec3& p : {Vec3{0, y, 0}, rim(i, y), rim(i + 1, y)})
        scene.points.push_back(p);
      scene.triangles.push_back(y > 0 ? std::array<std::uint32_t, 3>{first, first + 1, first + 2}
                                      : std::array<std::uint32_t, 3>{first, first + 2, first + 1});
      scene.triangleMaterial.push_back(material);
    }
  }
  rooms::addQuad(scene, {-2.5, 0, 0}, {5, 0, 0}, {0, 5, 0}, material);
  return scene;
}
}  // namespace

// Facets that lean away by 6 degrees are no reason to gather but for the last hundredth of a metre before an edge: at
// the middle of each, 7 receivers, and 2 mm from an edge, one. Closed form.
TEST(GatherEffort, FacetsOfAVaultNeedNone)
{
  const double rho = 0.6;
  const Scene scene(vault(rho, 250 * (1 - rho)));
  Receivers r;
  for (double facet : {8.5, 10.5, 12.5, 15.5, 17.5, 20.5, 21.5, 11.0 + 2e-3 / 0.2617})
  {
    const auto i = std::floor(facet);
    auto rim = [](double k) { return Vec3{2.5 * std::cos(pi * k / 30), 2.5, 2.5 * std::sin(pi * k / 30)}; };
    const Vec3 a = rim(i), along = rim(i + 1) - a;
    const Vec3 inwards = cross(along, {0, 1, 0});
    add(r, a + (facet - i) * along, (1 / length(inwards)) * inwards);
  }
  const Result sparing = solve(scene, r, settings(false, 5)), all = solve(scene, r, settings(true, 6));
  EXPECT_EQ(gatheringReceivers(sparing), "at 1 of 8 receivers");
  EXPECT_EQ(gatheringReceivers(all), "at 8 of 8 receivers");
  EXPECT_GT(sparing.gatherRays[7], 0);
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(sparing.gatherRays[i], 0);
    EXPECT_GT(all.gatherRays[i], 500);
  }
  EXPECT_LT(sparing.rays + 7 * 65536 / 80, all.rays + 100);  // no shadow rays in this room, so little else
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    EXPECT_LT(std::abs(sparing.illuminance[i] - 250), allowed(sparing, 8) * sparing.standardError[i]) << i;
    EXPECT_LT(sparing.standardError[i], 0.01 * 250) << i;
    EXPECT_LT(sparing.standardError[i], 1.5 * all.standardError[i]) << i;
    EXPECT_TRUE(sparing.trusted[i]);
  }
}
