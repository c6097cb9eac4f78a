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
      const SurfacePoint hit = scene.trace(scene.anchor(p, {0, 0, 1}), cosineHemisphere(u1, u2));
      lost += !hit.valid;
      outside += hit.valid && maxAbs(hit.position) > 2.5 + 1e-5;
    }
    EXPECT_LE(lost, 2) << "at " << away << " m";  // of 200 000
    EXPECT_EQ(outside, 0);
  }
}

namespace
{
// A prism whose long walls meet at the z axis at this angle.
SceneDescription wedge(double degrees)
{
  SceneDescription d;
  const auto m = rooms::addMaterial(d, 0.5);
  const double half = degrees * pi / 360, reach = 4;
  const Vec3 corners[3] = {
      {}, {reach * std::cos(half), -reach * std::sin(half), 0}, {reach * std::cos(half), reach * std::sin(half), 0}};
  const Vec3 up{0, 0, 3};
  for (int i = 0; i < 3; ++i)
    rooms::addQuad(d, corners[i], up, corners[(i + 1) % 3] - corners[i], m);
  for (int k = 0; k < 2; ++k)
  {
    const auto first = static_cast<std::uint32_t>(d.points.size());
    for (const Vec3& c : corners)
      d.points.push_back(c + double(k) * up);
    d.triangles.push_back({first, first + 1, first + 2});
    d.triangleMaterial.push_back(m);
  }
  return d;
}

// Distance to the first triangle ahead, all in double precision; of the wall that p lies on no triangle is ahead.
double firstAhead(const Scene& scene, const Vec3& p, const Vec3& direction)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    const Vec3 &n = scene.normal(t), a = scene.corner(t, 0);
    const double height = dot(n, p - a), distance = -height / dot(n, direction);
    if (std::abs(height) < 1e-7 || !(distance > 0 && distance < nearest))
      continue;
    const Vec3 q = p + distance * direction;
    bool inside = true;
    for (int i = 0; i < 3; ++i)
      inside = inside && dot(cross(scene.corner(t, (i + 1) % 3) - scene.corner(t, i), q - scene.corner(t, i)), n) >= 0;
    if (inside)
      nearest = distance;
  }
  return nearest;
}
}  // namespace

// Where two walls meet at 5 degrees and are a few micrometres apart or less, single precision rays have no room to keep
// off their own wall: they must still end where an obvious sibling in double precision says.
TEST(RayScene, RaysFindTheirWayOutOfNarrowGaps)
{
  for (double away : {0.0, 1000.0, 1e6})
  {
    SceneDescription description = wedge(5);
    const Vec3 shift{away, -2 * away, away};
    rooms::translate(description, shift);
    const Scene scene(description);
    const Vec3 along = normalized(scene.corner(0, 2) - scene.corner(0, 0) - (scene.corner(0, 1) - scene.corner(0, 0)));
    const Vec3 n =
        dot(scene.normal(0), scene.corner(4, 0) - scene.corner(0, 0)) > 0 ? scene.normal(0) : -scene.normal(0);
    RandomStream random(12, 0, Purpose::Gather, 0);
    for (double h : {1e-5, 1e-4, 1e-2})
    {
      int wrong = 0, hidden = 0;
      const int count = 20000;
      for (int i = 0; i < count; ++i)
      {
        const Vec3 p = scene.corner(0, 0) + h * along + Vec3{0, 0, 0.5 + 2 * random.next()};
        const double u1 = random.next(), u2 = random.next();
        const Vec3 direction = Frame(n).toWorld(cosineHemisphere(u1, u2));
        const double distance = firstAhead(scene, p, direction);
        if (!std::isfinite(distance))  // walls of rounded coordinates leave gaps of 1e-10 m
        {
          ++wrong;
          continue;
        }
        const SurfacePoint hit = scene.trace(scene.anchor(p, n), direction);
        wrong += !hit.valid || length(hit.position - p - distance * direction) > 1e-5;
        const RayAnchor anchor = scene.anchor(p, n);
        hidden += scene.rays().occluded(anchor, p + 0.999 * distance * direction) ||
                  !scene.rays().occluded(anchor, p + 1.001 * distance * direction);
      }
      EXPECT_LE(wrong, 4) << h << " m from the edge, " << away << " m from the origin";  // of 20 000
      EXPECT_LE(hidden, 20) << h << " m from the edge, " << away << " m from the origin";
    }
  }
}

// Layers that coincide but for rounding: a ray off the lower one is not caught below the upper one.
TEST(RayScene, LayersThatNearlyCoincideHideNothing)
{
  SceneDescription d = rooms::litRoom(0.5);
  rooms::addQuad(d, {1, 1, 1e-6}, {3, 0, 0}, {0, 3, 1e-7}, 0);
  const Scene scene(d);
  const Vec3 below = Vec3{2, 2, 0} - scene.origin(), up{0, 0, 1};
  EXPECT_GT(scene.trace(scene.anchor(below, up), normalized(Vec3{0.3, 0.2, 1})).position.z, 0);
  EXPECT_FALSE(scene.rays().occluded(scene.anchor(below, up), Vec3{1, 0, 0}));
  EXPECT_TRUE(scene.rays().occluded(scene.anchor(below - 2e-5 * up, up), Vec3{1, 0, 0}));
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

// Rays of every kind are counted, also those of threads that have ended.
TEST(RayScene, RaysAreCounted)
{
  const Scene scene(rooms::litRoom(0.5));
  const long long before = raysTraced();
  scene.rays().intersect(Vec3{0, 0, 0}, {0, 0, 1});
  scene.rays().occluded(Vec3{0, 0, 0}, Vec3{0, 0, 1});
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
  const RayScene rays(d.points, d.triangles);
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
