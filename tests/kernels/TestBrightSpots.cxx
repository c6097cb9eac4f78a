// SPDX-License-Identifier: BSD-3-Clause
// Light that gather rays find only by luck: vertices beside lamps take it, and no score is out of bounds.
#include <gtest/gtest.h>

#include <numeric>

#include "Rooms.h"
#include "estimator/gathering/BrightSpots.h"
#include "estimator/solve/Solver.h"

using namespace kalos;

namespace
{
constexpr int trajectories = 20000;

// The room of 5 m with its lamp moved.
SceneDescription roomWithLamp(const Vec3& position, double reflectance = 0.7)
{
  SceneDescription d = rooms::litRoom(reflectance);
  d.luminaires[0].position = position;
  d.luminaires[0].distribution = Distribution::Isotropic;
  return d;
}

// The area of all surfaces, m2, by first hits of the lamp: each stands for 1/(N D) of it.
double areaByFirstHits(const SceneDescription& d)
{
  const Scene scene(d);
  const LightVertices found = traceTrajectories(scene, Emission(scene), {}, 0, 0, trajectories);
  double sum = 0;
  for (const float density : found.reflected.firstHitDensity)
    sum += density > 0 ? 1 / (static_cast<double>(density) * trajectories) : 0;
  return sum;
}

struct Spots
{
  Scene scene;
  Emission emission;
  GatherContext context;
  BrightSpots spots;

  explicit Spots(const SceneDescription& d)
      : scene(d), emission(this->scene), context(this->scene, this->emission, {}, true), spots(this->context)
  {
    std::vector<Sensor> sensors;
    for (int i = 0; i < 40; ++i)
      sensors.emplace_back(
          placeReceiver(this->scene, Vec3{0.3 + 0.11 * i, 4.7 - 0.1 * i, 0} - this->scene.origin(), {0, 0, 1}));
    this->spots.prepare(sensors);
  }
};

Result solveBeside(const Scene& scene, Method method, long long count)
{
  Receivers r;
  for (int i = 0; i < 64; ++i)
  {
    r.points.push_back({0.3 + 0.6 * (i % 8), 0.3 + 0.6 * (i / 8), 0});
    r.normals.push_back({0, 0, 1});
  }
  Settings s;
  s.method = method;
  s.trajectories = count;
  return solve(scene, r, s);
}
}  // namespace

// The density of first hits is exact: 20 000 of them find the area of the room to a few per cent.
TEST(BrightSpots, FirstHitsAreAsDenseAsTheySay)
{
  SceneDescription d = roomWithLamp({2, 2.5, 2});
  EXPECT_NEAR(areaByFirstHits(d), 150, 0.03 * 150);
  d.luminaires[0].sideU = {1, 0, 0};
  d.luminaires[0].sideV = {0, 0.5, 0};
  d.luminaires[0].distribution = Distribution::Lambertian;
  EXPECT_NEAR(areaByFirstHits(d), 150 - 25 - 4 * 15, 0.03 * 65);  // it lights what is below 2 m
  const Luminaire same = d.luminaires[0];
  d.luminaires.push_back(same);
  EXPECT_NEAR(areaByFirstHits(d), 2 * 65, 0.03 * 130);  // each by its own hits
}

// Vertices take the spot beside a lamp, nothing far from it.
TEST(BrightSpots, VerticesTakeWhatLiesDense)
{
  const Spots s(roomWithLamp({2.5, 2.5, 4.99}));
  ASSERT_TRUE(s.spots.any());
  EXPECT_EQ(s.spots.split(0.005).least, 1);
  EXPECT_EQ(s.spots.split(0.005).gathered(0.1, 1), 1);
  const BrightSpots::Split spot = s.spots.split(800);
  EXPECT_LT(spot.least, 0.001);
  EXPECT_LT(spot.gathered(0.01, 1), 0.001);
  EXPECT_GT(spot.gathered(1e6, 1), 0.999);  // near the receiver, rays find it
}

// The worst pairs of density and kernel: what a gather ray and a vertex score, in units of rho Phi/N.
TEST(BrightSpots, NoScoreIsOutOfBounds)
{
  const Spots s(roomWithLamp({2.5, 2.5, 4.99}));
  double least = 1e-6;  // D0
  while (!s.spots.split(least).isShared())
    least *= 1.001;
  for (const double rays : {0.01, 1.0, 100.0})  // four times those per trajectory
    for (double density = 1e-4; density < 1e12; density *= 3)
      for (double kernel = 1e-12; kernel < 1e12; kernel *= 3)
      {
        const BrightSpots::Split split = s.spots.split(density);
        const double gathered = split.gathered(kernel, rays), n = rays / 4;
        EXPECT_LE(gathered * density / n, (least + 4 * n * kernel) / n * 1.002);
        EXPECT_LE((1 - gathered) * kernel, density / (4 * n) * 1.000001);
      }
}

// A vertex is kept with probability A, with all of its flux.
TEST(BrightSpots, SelectionKeepsTheShare)
{
  const Spots s(roomWithLamp({2.5, 2.5, 4.8}));
  LightVertices pool = traceTrajectories(s.scene, s.emission, {}, 0, 0, trajectories);
  s.context.pilot().annotate(pool);
  double expected = 0, marginal = 0;
  for (std::size_t i = 0; i < pool.reflected.size(); ++i)
  {
    const double most = 1 - s.spots.split(1 / static_cast<double>(pool.reflected.inverseDensity[i])).least;
    expected += most * static_cast<double>(pool.reflected.luminous[i]);
    marginal += most > 0.2 && most < 0.8;
  }
  const LightVertices kept = s.spots.select(pool, 0.3);
  EXPECT_GT(marginal, 100);
  EXPECT_LT(kept.reflected.size(), pool.reflected.size() / 2);
  const double sum = std::accumulate(kept.reflected.luminous.begin(), kept.reflected.luminous.end(), 0.0);
  EXPECT_NEAR(sum, expected, 2 * static_cast<double>(pool.reflected.luminous[0]));
}

// Lamps near a ceiling and in a corner: the same as by `compensated`, within 6.5 standard errors (7 degrees of freedom:
// false alarm 0.02 over all), and with small errors. The mean of all is within 1 %.
TEST(BrightSpots, GatheredIsRightBesideLamps)
{
  for (const Vec3 lamp : {Vec3{2.5, 2.5, 4.99}, {2.5, 2.5, 4.9999}, {0.01, 0.01, 4.99}})
  {
    const Scene scene(roomWithLamp(lamp));
    const Result gathered = solveBeside(scene, Method::Gathered, 32768);
    const Result judge = solveBeside(scene, Method::Compensated, 131072);
    double sums[2] = {};
    int trusted = 0;
    for (std::size_t i = 0; i < judge.illuminance.size(); ++i)
    {
      const double error = std::hypot(gathered.standardError[i], judge.standardError[i]);
      EXPECT_LT(std::abs(gathered.illuminance[i] - judge.illuminance[i]), 6.5 * error) << "receiver " << i;
      EXPECT_LT(gathered.standardError[i], 0.02 * gathered.illuminance[i]);
      trusted += gathered.trusted[i];
      sums[0] += gathered.illuminance[i];
      sums[1] += judge.illuminance[i];
    }
    EXPECT_NEAR(sums[0] / sums[1], 1, 0.01);
    EXPECT_GT(trusted, 56);
  }
}

// A small bright mesh whose light is not known in closed form, because other meshes are too many.
TEST(BrightSpots, SmallBrightMeshesAreFound)
{
  SceneDescription d = rooms::litRoom(0.5, 0);
  const std::uint32_t bright = rooms::addMaterial(d, 0, 1e6), dim = rooms::addMaterial(d, 0.5, 0.01);
  rooms::addQuad(d, {2, 2, 4}, {0, 0.03, 0}, {0.03, 0, 0}, bright);
  for (int i = 0; i < 2100; ++i)
    rooms::addQuad(d, {1 + 0.001 * i, 4.9, 1}, {0, 0, 1}, {0.001, 0, 0}, dim);
  const Scene scene(d);
  const Result gathered = solveBeside(scene, Method::Gathered, 8192);
  const Result judge = solveBeside(scene, Method::Compensated, 32768);
  for (std::size_t i = 0; i < judge.illuminance.size(); ++i)
  {
    EXPECT_LT(gathered.standardError[i], 0.05 * gathered.illuminance[i]);
    EXPECT_NEAR(gathered.illuminance[i], judge.illuminance[i],
                7 * std::hypot(gathered.standardError[i], judge.standardError[i]));
  }
}
