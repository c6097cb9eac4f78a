// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "Rooms.h"
#include "estimator/kernel/VertexResampling.h"
#include "estimator/tracing/Trajectories.h"
#include "estimator/tracing/VertexOrder.h"
#include "estimator/tracing/VertexRound.h"

using namespace kalos;

namespace
{
constexpr int lanes = VertexTile::lanes;
const Brdf brdfs[2] = {Brdf(Material{}, 1), Brdf(Material{}, 1)};

// Vertices in a box of 4 m x 2 m x 1 m, every value of which tells which one it is.
VertexSet numbered(int count)
{
  VertexSet v(2);
  RandomStream random(1, 0, Purpose::Trajectory, 0);
  for (int i = 0; i < count; ++i)
  {
    const auto number = static_cast<float>(i);
    v.px.push_back(4 * static_cast<float>(random.next()));
    v.py.push_back(2 * static_cast<float>(random.next()));
    v.pz.push_back(static_cast<float>(random.next()));
    for (std::vector<float>* values :
         {&v.nx, &v.ny, &v.nz, &v.lift, &v.slope, &v.inverseDensity, &v.luminous, &v.flux[0], &v.flux[1]})
      values->push_back(number);
    v.brdf.push_back(&brdfs[i % 2]);
    v.incident.push_back({number, 0, 0});
  }
  return v;
}

struct Box
{
  Vec3 low, high;
};

Box boxOf(const VertexSet& v, std::size_t begin, std::size_t end)
{
  Box box{v.position(begin), v.position(begin)};
  for (std::size_t i = begin; i < end; i += lanes)
    for (double Vec3::*x : {&Vec3::x, &Vec3::y, &Vec3::z})
    {
      box.low.*x = std::min(box.low.*x, v.position(i).*x);
      box.high.*x = std::max(box.high.*x, v.position(i).*x);
    }
  return box;
}

bool apart(const Box& a, const Box& b)
{
  for (double Vec3::*x : {&Vec3::x, &Vec3::y, &Vec3::z})
    if (a.high.*x <= b.low.*x || b.high.*x <= a.low.*x)
      return true;
  return false;
}

// Pairs of lanes among vertices [begin, end) that share space.
int overlaps(const VertexSet& v, std::size_t begin, std::size_t end)
{
  int found = 0;
  for (std::size_t a = begin; a < begin + lanes; ++a)
    for (std::size_t b = begin; b < a; ++b)
      found += !apart(boxOf(v, a, end), boxOf(v, b, end));
  return found;
}
}  // namespace

TEST(VertexOrder, VerticesKeepWhatIsTheirsAndStayInTheirTile)
{
  const VertexSet before = numbered(1300);
  VertexSet v = before;
  spreadOverLanes(v);
  ASSERT_EQ(v.size(), before.size());
  std::vector<char> seen(v.size(), 0);
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    const float number = v.luminous[i];
    const auto was = static_cast<std::size_t>(number);
    seen[was] = 1;
    EXPECT_EQ(i / VertexTile::capacity, was / VertexTile::capacity);
    EXPECT_EQ(length(v.position(i) - before.position(was)), 0);
    for (const float value :
         {v.nx[i], v.ny[i], v.nz[i], v.lift[i], v.slope[i], v.inverseDensity[i], v.flux[0][i], v.flux[1][i]})
      EXPECT_EQ(value, number);
    EXPECT_EQ(v.brdf[i], before.brdf[was]);
    EXPECT_EQ(v.incident[i].x, number);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 1300);
}

// A whole tile and what is left for the last one.
TEST(VertexOrder, EachLaneHasSpaceOfItsOwn)
{
  VertexSet v = numbered(512 + 77);
  spreadOverLanes(v);
  for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 512}, {512, 512 + 77}})
  {
    EXPECT_EQ(overlaps(v, begin, end), 0);
    for (std::size_t i = begin; i + lanes < end; ++i)
      EXPECT_LT(v.luminous[i], v.luminous[i + lanes]) << "lanes keep the order";
  }
}

TEST(VertexOrder, FewVerticesAreNoTrouble)
{
  for (const int count : {0, 1, 3, 16, 17})
  {
    VertexSet v = numbered(count);
    spreadOverLanes(v);
    EXPECT_EQ(v.size(), static_cast<std::size_t>(count));
  }
}

// 32 of 512 vertices, 200 times in each of 40 tiles, at a sensor that boxes hide many of them from. Fixed seeds:
// nothing is left to chance.
TEST(VertexOrder, PicksVaryLess)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  const Emission emission(scene);
  constexpr std::size_t tiles = 40, size = VertexTile::capacity;
  VertexSet traced = traceTrajectories(scene, emission, {}, 0, 0, 16384).reflected;
  std::fill(traced.inverseDensity.begin(), traced.inverseDensity.end(), 0.0f);  // scored whole
  ASSERT_GE(traced.size(), tiles * size);
  VertexSet spread = traced;
  spreadOverLanes(spread);
  const Sensor sensor(placeReceiver(scene, Vec3{0.8, 2.5, 0} - scene.origin(), {0, 0, 1}));
  auto variance = [&](const VertexSet& v) {
    RandomStream random(7, 0, Purpose::Selection, 0);
    double all = 0;
    for (std::size_t t = 0; t < tiles; ++t)
    {
      double sum = 0, squares = 0;
      constexpr int times = 200;
      for (int i = 0; i < times; ++i)
      {
        double e = 0;
        addResampledScores(v, t * size, size, sensor, 0, {&scene.rays(), 32, random.next()}, &e);
        sum += e / times;
        squares += e * e / times;
      }
      all += squares - sum * sum;
    }
    return all;
  };
  const double ratio = variance(traced) / variance(spread);
  std::cout << "variance as traced over spread " << ratio << "\n";
  EXPECT_GT(ratio, 1.5);
}

TEST(VertexOrder, RoundsAreSpreadWhereWalksAreStratified)
{
  const Scene scene(rooms::furnishedRoom(0.5));
  const Emission emission(scene);
  const Ranks alone;
  Workers workers(1, {}, alone);
  for (const Sampling sampling : {Sampling::Sobol, Sampling::Independent})
  {
    const std::vector<LightVertices> pools = traceRound(scene, emission, {1, sampling}, 2, 0, 600, workers);
    for (const LightVertices& pool : pools)
    {
      ASSERT_GT(pool.reflected.size(), 512u);
      EXPECT_EQ(overlaps(pool.reflected, 0, 512), sampling == Sampling::Sobol ? 0 : lanes * (lanes - 1) / 2);
    }
  }
}
