// SPDX-License-Identifier: BSD-3-Clause
// Trajectories start where receivers need them.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "Rooms.h"
#include "Student.h"
#include "estimator/solve/Solver.h"
#include "estimator/tracing/EmissionPilot.h"
#include "estimator/tracing/EmitterGroups.h"
#include "estimator/tracing/Trajectories.h"
#include "estimator/tracing/VertexOrder.h"
#include "estimator/tracing/VertexTile.h"

using namespace kalos;

namespace
{
Luminaire lamp(const Vec3& position, double flux)
{
  Luminaire made;
  made.position = position;
  made.flux = flux;
  made.distribution = Distribution::Isotropic;
  return made;
}

// On the floor and the walls of a room with a corner at `low`.
Receivers inRoom(const Vec3& low, const Vec3& size)
{
  Receivers made;
  for (const double x : {0.1, 0.3, 0.5})
    for (const double y : {0.3, 0.7})
    {
      made.points.push_back(low + Vec3{x * size.x, y * size.y, 0});
      made.normals.push_back({0, 0, 1});
      made.points.push_back(low + Vec3{0, x * size.y, y * size.z});
      made.normals.push_back({1, 0, 0});
    }
  return made;
}

Settings settings(Method method, std::uint64_t seed = 1, long long trajectories = 4096)
{
  Settings s;
  s.method = method;
  s.seed = seed;
  s.trajectories = trajectories;
  s.threads = 1;
  return s;
}

// A white furnace of a lumen beside a hall under a lamp of a million: E = 0.2 lx everywhere in the closet.
const Vec3 closetSize{1, 1, 2};
SceneDescription closetAndHall()
{
  SceneDescription scene;
  rooms::addBox(scene, {0, 0, 0}, closetSize, rooms::addMaterial(scene, 0.5, 0.1), true);
  rooms::addBox(scene, {2, 0, 0}, {20, 20, 8}, rooms::addMaterial(scene, 0.7), true);
  scene.luminaires.push_back(lamp({12, 9, 6}, 1e6));
  return scene;
}

// Lit rooms in a row, 0.1 m apart.
const Vec3 roomSize{4, 3, 2.5};
SceneDescription building(int count)
{
  SceneDescription scene;
  const auto white = rooms::addMaterial(scene, 0.6);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 low{0, 3.1 * i, 0};
    rooms::addBox(scene, low, roomSize, white, true);
    rooms::addBox(scene, low + Vec3{2.6, 0.6, 0}, {0.8, 0.7, 0.8}, white, false);
    scene.luminaires.push_back(lamp(low + Vec3{1.7, 1.4, 2.2}, 1500));
  }
  return scene;
}
}  // namespace

// 12 receivers and three methods: allowed() with one false alarm in a thousand seeds. Without guiding, no trajectory of
// 4096 starts in the closet.
TEST(Guiding, AClosetBesideABrightHallIsRight)
{
  const Scene scene(closetAndHall());
  const Receivers receivers = inRoom({0, 0, 0}, closetSize);
  for (const Method method : {Method::Compensated, Method::Gathered, Method::Local})
  {
    const Result result = solve(scene, receivers, settings(method));
    for (std::size_t r = 0; r < receivers.points.size(); ++r)
    {
      EXPECT_LT(std::abs(result.illuminance[r] - 0.2), allowed(result, 36) * result.standardError[r] + 1e-6)
          << "method " << static_cast<int>(method) << ", receiver " << r;
      if (method != Method::Local)
      {
        EXPECT_LT(result.standardError[r], 0.03 * 0.2) << "receiver " << r;
      }
    }
    EXPECT_TRUE(std::any_of(result.audit.begin(), result.audit.end(),
                            [](const AuditLine& line) { return line.subject == "trajectories"; }));
  }
}

// A closet lit by a luminous mesh of its own, beside a hall with one of a hundred thousand times its exitance, against
// the closet alone: allowed() of 24 differences.
TEST(Guiding, APanelBesideABrightHallIsRight)
{
  auto lit = [](bool beside) {
    SceneDescription scene;
    rooms::addBox(scene, {0, 0, 0}, closetSize, rooms::addMaterial(scene, 0.7), true);
    rooms::addQuad(scene, {0.3, 0.3, 1.95}, {0, 0.3, 0}, {0.3, 0, 0}, rooms::addMaterial(scene, 0, 10));
    if (beside)
    {
      rooms::addBox(scene, {2, 0, 0}, {20, 20, 8}, 0, true);
      rooms::addQuad(scene, {12, 9, 7.9}, {0, 1, 0}, {1, 0, 0}, rooms::addMaterial(scene, 0, 1e6));
    }
    return scene;
  };
  const Receivers receivers = inRoom({0, 0, 0}, closetSize);
  const Scene both(lit(true)), single(lit(false));
  for (const Method method : {Method::Compensated, Method::Gathered})
  {
    const Result beside = solve(both, receivers, settings(method)), alone = solve(single, receivers, settings(method));
    for (std::size_t r = 0; r < receivers.points.size(); ++r)
      EXPECT_LT(std::abs(beside.illuminance[r] - alone.illuminance[r]),
                allowed(beside, alone, 24) * std::hypot(beside.standardError[r], alone.standardError[r]))
          << "method " << static_cast<int>(method) << ", receiver " << r;
  }
}

// Cost is counted in rays: times variance, over twelve receivers and six seeds, at most 1.5 times that of the room
// alone (it is 1.1 to 1.2). Without guiding it is above 20.
TEST(Guiding, ARoomOfABuildingCostsAsMuchAsAlone)
{
  auto effort = [](int count) {
    const Scene scene(building(count));
    const Receivers receivers = inRoom({0, 3.1 * (count / 2), 0}, roomSize);
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
    {
      const Result result = solve(scene, receivers, settings(Method::Compensated, seed));
      for (std::size_t r = 0; r < receivers.points.size(); ++r)
        sum += static_cast<double>(result.rays) * std::pow(result.standardError[r] / result.illuminance[r], 2);
    }
    return sum;
  };
  const double ratio = effort(40) / effort(1);
  std::cout << "one of forty rooms takes " << ratio << " times the work of the room alone\n";
  EXPECT_LT(ratio, 1.5);
}

// Every emitter keeps a tenth of its share, so that no weight is above ten times what it would be.
TEST(Guiding, NothingIsLeftOut)
{
  const Scene scene(closetAndHall());
  const Emission emission = makeEmission(scene, inRoom({0, 0, 0}, closetSize), settings(Method::Compensated));
  ASSERT_TRUE(emission.isGuided());
  double sum = 0, closet = 0;
  for (std::size_t i = 0; i < emission.emitters(); ++i)
  {
    const double p = emission.probability(i);
    sum += p;
    closet += i > 0 ? p : 0;
    EXPECT_GE(p, 0.0999 * emission.flux(i) / emission.totalFlux());
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_GT(closet, 0.85);
  for (int i = 0; i < 1000; ++i)
  {
    const EmissionSample start = [&] {
      SampleStream random(Sampling::Independent, 3, 0, Purpose::Trajectory, i);
      return emission.sample(random);
    }();
    EXPECT_LT(start.weight[0], 10.01 * emission.totalFlux());
    if (start.onSurface)
    {
      EXPECT_NEAR(start.density, emission.startDensity(start.triangle), 1e-12 * start.density);
    }
  }
}

TEST(Guiding, WhereAllReceiversProfitAlikeFluxDecides)
{
  SceneDescription office = rooms::furnishedRoom(0.6);
  office.luminaires.clear();
  for (const double x : {1.2, 3.8})
    for (const double y : {1.2, 3.8})
      office.luminaires.push_back(lamp({x, y, 4.5}, 2000));
  const Scene scene(office);
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_FALSE(makeEmission(scene, inRoom({0, 0, 0}, {5, 5, 5}), settings(Method::Compensated, seed)).isGuided())
        << "seed " << seed;
}

TEST(Guiding, DoesNotDependOnThreads)
{
  const Scene scene(building(5));
  const Receivers receivers = inRoom({0, 0, 0}, roomSize);
  Settings s = settings(Method::Gathered, 1, 1024);
  const Result one = solve(scene, receivers, s);
  s.threads = 3;
  EXPECT_EQ(one.illuminance, solve(scene, receivers, s).illuminance);
}

TEST(EmitterGroups, AreNearAndAboutAsBright)
{
  SceneDescription d = building(10);
  d.luminaires.push_back(lamp({1.7, 1.45, 2.2}, 15));     // beside the first, a hundredth as bright
  d.luminaires.push_back(lamp({1.7, 1.45, 2.25}, 1400));  // beside the first
  d.luminaires.push_back(lamp({1, 1, 1}, 0));
  const Scene scene(d);
  const EmitterGroups groups = groupEmitters(scene, Emission(scene));
  EXPECT_EQ(groups.count, 11);
  EXPECT_EQ(groups.of[11], groups.of[0]);
  EXPECT_EQ(groups.of[12], -1);
  EXPECT_EQ(std::set<int>(groups.of.begin(), groups.of.begin() + 11).size(), 11u);
}

TEST(EmitterGroups, AreLimitedInNumber)
{
  SceneDescription d = rooms::litRoom(0.5);
  for (int i = 0; i < 1000; ++i)
    d.luminaires.push_back(lamp({0.2 + 0.14 * (i % 32), 0.2 + 0.14 * (i / 32), 4}, 100));
  const Scene scene(d);
  const EmitterGroups groups = groupEmitters(scene, Emission(scene));
  EXPECT_GT(groups.count, 20);
  EXPECT_LE(groups.count, EmitterGroups::most);
}

// Vertices of three strata in turn: apart afterwards, in their order.
TEST(VertexStrata, AreApart)
{
  VertexSet v;
  for (int i = 0; i < 1500; ++i)
  {
    v.add(RayAnchor(Vec3{1.0 * i, 0, 0}), uniformBands(i + 1));
    v.stratum.push_back(static_cast<std::uint8_t>(i % 7 == 0 ? 8 : i % 2));
  }
  separateStrata(v);
  ASSERT_EQ(v.strata(), 3u);
  EXPECT_EQ(v.stratumEnd(2), v.size());
  for (std::size_t i = 1; i < v.size(); ++i)
    EXPECT_TRUE(v.stratum[i - 1] < v.stratum[i] ||
                (v.stratum[i - 1] == v.stratum[i] && v.luminous[i - 1] < v.luminous[i]));
  std::size_t next = 0;
  forEachTile(v, [&](std::size_t begin, int count) {
    EXPECT_EQ(begin, next);
    next += count;
    EXPECT_LE(count, VertexTile::capacity);
    EXPECT_EQ(v.stratum[begin], v.stratum[next - 1]) << "one stratum per tile";
  });
  EXPECT_EQ(next, v.size());
  spreadOverLanes(v);
  forEachTile(v, [&](std::size_t begin, int count) {
    EXPECT_EQ(v.stratum[begin], v.stratum[begin + count - 1]) << "vertices stay in their tile";
  });
}
