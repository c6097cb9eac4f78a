// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "Rooms.h"
#include "sampling/Random.h"
#include "sampling/Warp.h"
#include "scene/RayCount.h"

using namespace kalos;

// A closed room holds every ray, also when it stands 1 km away and when the rays start 0.1 mm from an edge.
TEST(RayScene, AClosedRoomDoesNotLeak)
{
  for (double away : {0.0, 1000.0})
  {
    SceneDescription description = rooms::litRoom(0.5);
    const Vec3 shift{away, -2 * away, away};
    rooms::translate(description, shift);
    const Scene scene(description);
    int lost = 0, outside = 0;
    const int count = 200000;
    RandomStream random(11, 0, Purpose::Gather, 0);
    for (int i = 0; i < count; ++i)
    {
      const double near = i % 2 ? 1e-4 : 2;
      const Vec3 p = Vec3{near, 5 * random.next(), 0} + shift - scene.origin();
      const double u1 = random.next(), u2 = random.next();
      const SurfacePoint hit = scene.trace(p, {0, 0, 1}, cosineHemisphere(u1, u2));
      lost += !hit.valid;
      outside += hit.valid && maxAbs(hit.position) > 2.5 + 1e-5;
    }
    EXPECT_LE(lost, 2) << "at " << away << " m";  // of 200 000
    EXPECT_EQ(outside, 0);
  }
}

// A hit point lies in the plane of its triangle to double precision.
TEST(RayScene, HitPointsAreExact)
{
  const Scene scene(rooms::litRoom(0.5));
  const SurfacePoint hit = scene.trace(Vec3{0.3, 0.4, 1}, normalized(Vec3{0.1, -0.2, -1}));
  ASSERT_TRUE(hit.valid);
  EXPECT_NEAR(hit.position.z, -2.5, 1e-15);
  EXPECT_NEAR(hit.normal.z, 1, 1e-15);
  EXPECT_TRUE(hit.front);
}

// Rays of every kind are counted, also those of threads that are no more.
TEST(RayScene, RaysAreCounted)
{
  const Scene scene(rooms::litRoom(0.5));
  const long long before = raysTraced();
  scene.rays().intersect({0, 0, 0}, {0, 0, 1});
  scene.rays().occluded({0, 0, 0}, {0, 0, 1});
  SegmentPacket packet{};
  std::thread([&] { scene.rays().occluded(packet, 5); }).join();
  EXPECT_EQ(raysTraced() - before, 7);
}

TEST(RayScene, PacketsAgreeWithSingleSegments)
{
  const Scene scene(rooms::furnace(0.5, 100));
  RandomStream random(5, 0, Purpose::Gather, 0);
  int hidden = 0;
  for (int round = 0; round < 500; ++round)
  {
    SegmentPacket packet;
    Vec3 a[16], b[16];
    for (int i = 0; i < 16; ++i)
    {
      a[i] = {4.9 * random.next() - 2.45, 4.9 * random.next() - 2.45, 4.9 * random.next() - 2.45};
      b[i] = {4.9 * random.next() - 2.45, 4.9 * random.next() - 2.45, 4.9 * random.next() - 2.45};
      packet.ox[i] = a[i].x, packet.oy[i] = a[i].y, packet.oz[i] = a[i].z;
      packet.dx[i] = b[i].x - a[i].x, packet.dy[i] = b[i].y - a[i].y, packet.dz[i] = b[i].z - a[i].z;
    }
    const std::uint32_t mask = scene.rays().occluded(packet, 11);
    EXPECT_EQ(mask >> 11, 0u) << "idle lanes";
    for (int i = 0; i < 11; ++i)
    {
      EXPECT_EQ(mask >> i & 1, scene.rays().occluded(a[i], b[i]) ? 1u : 0u);
      hidden += mask >> i & 1;
    }
  }
  EXPECT_GT(hidden, 500);
  EXPECT_LT(hidden, 4500);
}

TEST(RayScene, CrossingsFindEveryTriangle)
{
  SceneDescription d;
  const auto m = rooms::addMaterial(d, 0.5);
  for (int k = 0; k < 5; ++k)
    rooms::addQuad(d, {0, 0, double(k)}, {1, 0, 0}, {0, 1, 0}, m);
  const RayScene rays(d.points, d.triangles, RayScene::Queries::AllCrossings);
  std::vector<std::uint32_t> met;
  rays.crossings({0.3, 0.2, -1}, {0.3, 0.2, 3.5}, [&](std::uint32_t t) { met.push_back(t); });
  std::sort(met.begin(), met.end());
  EXPECT_EQ(met, (std::vector<std::uint32_t>{0, 2, 4, 6}));
}

TEST(Scene, RefusesWhatItCanNotModel)
{
  auto message = [](SceneDescription d) -> std::string {
    try
    {
      const Scene scene(std::move(d));
      return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  SceneDescription flat = rooms::litRoom(0.5);
  flat.points[2] = flat.points[1];
  EXPECT_EQ(message(flat), "triangle 0: has no area");
  SceneDescription infinite = rooms::litRoom(0.5);
  infinite.points[5].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(infinite), "point 5: coordinates must be finite");
  SceneDescription missing = rooms::litRoom(0.5);
  missing.triangles[3][1] = 999;
  EXPECT_EQ(message(missing), "triangle 3: names a point that does not exist");
  SceneDescription bare = rooms::litRoom(0.5);
  bare.triangleMaterial[4] = 7;
  EXPECT_EQ(message(bare), "triangle 4: has no material");
  SceneDescription bands = rooms::litRoom(0.5);
  bands.bands = 99;
  EXPECT_EQ(message(bands), "bands: must be 1 to 16");
}
