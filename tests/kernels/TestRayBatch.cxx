// SPDX-License-Identifier: BSD-3-Clause
// Rays traced in packets find what each finds alone.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/control/Settings.h"
#include "estimator/gathering/WavefrontGather.h"
#include "estimator/tracing/Trajectories.h"
#include "sampling/Warp.h"
#include "scene/RayBatch.h"

using namespace kalos;

namespace
{
// Points of surfaces, with unit normals.
VertexSet places(const Scene& scene, int trajectories)
{
  return traceTrajectories(scene, Emission(scene), {}, 0, 0, trajectories).reflected;
}

SampleStream stream(std::uint64_t walk)
{
  return SampleStream(Sampling::Independent, 7, 0, Purpose::Gather, walk);
}
}  // namespace

TEST(RayBatch, FirstHitsAreThoseOfSingleRays)
{
  const Scene scene(rooms::furnishedRoom(0.6));
  const VertexSet from = places(scene, 20000);
  std::vector<PathRay> rays;
  SampleStream random = stream(0);
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const double u1 = random.next(), u2 = random.next();
    const Vec3 n = from.normal(i);
    rays.push_back({scene.anchor(from.position(i), n), Frame(n).toWorld(cosineHemisphere(u1, u2)), i % 5 == 0, {}});
  }
  traceTogether(scene, rays);
  int different = 0;
  for (const PathRay& ray : rays)
  {
    const SurfacePoint alone = scene.trace(ray.start, ray.direction);
    ASSERT_TRUE(ray.end.valid && alone.valid);
    if (ray.end.triangle != alone.triangle)
    {
      ++different;
      continue;
    }
    EXPECT_LT(length(ray.end.position - alone.position), 2e-3);  // a grazing ray, from a little higher
    EXPECT_EQ(ray.end.front, alone.front);
  }
  EXPECT_GT(rays.size(), 10000u);
  EXPECT_LT(different, 10) << "of " << rays.size() << ", at edges";
}

TEST(RayBatch, ShadowsAreThoseOfSingleRays)
{
  const Scene scene(rooms::furnishedRoom(0.6));
  const VertexSet set = places(scene, 20000);
  std::vector<ShadowRay> rays;
  for (std::size_t i = 0; i < set.size(); ++i)
  {
    const std::size_t j = (i * 7919 + 13) % set.size();
    rays.push_back({scene.anchor(set.position(i), set.normal(i)), scene.anchor(set.position(j), set.normal(j)), false});
  }
  shadowTogether(scene.rays(), rays);
  int hidden = 0, different = 0;
  for (const ShadowRay& ray : rays)
  {
    hidden += ray.hidden;
    different += ray.hidden != scene.rays().occluded(ray.from, ray.to);
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_LT(hidden, static_cast<int>(rays.size()) - 1000);
  EXPECT_LT(different, static_cast<int>(rays.size()) / 1000) << "of " << rays.size() << ", at edges";
}

// What lies nearer than 250 times what a start is lifted is found in double precision, to the last bit.
TEST(RayBatch, NearSurfacesAreMetAsAlone)
{
  SceneDescription d = rooms::furnishedRoom(0.6);
  const double gap = 1e-4;
  rooms::addQuad(d, {2, 2, gap}, {0, 1, 0}, {1, 0, 0}, 0);  // over the floor
  const Scene scene(d);
  const Vec3 up{0, 0, 1}, p = Vec3{2.5, 2.5, 0} - scene.origin();
  std::vector<PathRay> rays;
  for (double x = -0.9; x < 1; x += 0.1)
    rays.push_back({scene.anchor(p, up), normalized({x, 0.3, 1}), false, {}});
  traceTogether(scene, rays);
  for (const PathRay& ray : rays)
  {
    const SurfacePoint alone = scene.trace(ray.start, ray.direction);
    EXPECT_EQ(ray.end.triangle, alone.triangle);
    EXPECT_EQ(length(ray.end.position - alone.position), 0);
    EXPECT_NEAR(ray.end.position.z - p.z, gap, 1e-9);
  }
  EXPECT_TRUE(isInGap(scene, scene.anchor(p, up)));
  EXPECT_FALSE(isInGap(scene, scene.anchor(Vec3{0.3, 0.3, 0} - scene.origin(), up)));
}

// Where a wedge is narrower than the lift of packets, rays that are traced singly meet its other side.
TEST(RayBatch, AloneTheyStayInTheNarrowestGap)
{
  SceneDescription d = rooms::furnishedRoom(0.6);
  const double slope = 0.1, gap = 2e-6;
  rooms::addQuad(d, {2.5 - gap / slope, 2, 0}, {0, 1, 0}, {1, 0, slope}, 0);
  const Scene scene(d);
  const Vec3 up{0, 0, 1}, p = Vec3{2.5, 2.5, 0} - scene.origin();
  ASSERT_GT(length(scene.anchor(p, up).lifted() - p), gap);
  ASSERT_TRUE(isInGap(scene, scene.anchor(p, up)));
  std::vector<PathRay> rays{{scene.anchor(p, up), normalized({0, 0.2, 1}), true, {}}};
  traceTogether(scene, rays);
  EXPECT_NEAR(rays[0].end.position.z - p.z, gap, 1e-9);
  std::vector<ShadowRay> shadows{{scene.anchor(p, up), scene.anchor(p + Vec3{0, 0, 5}, -up), true}};
  shadowTogether(scene.rays(), shadows);
  EXPECT_TRUE(shadows[0].hidden);
}

// A gather ray finds the same in any packet: replays and tiles rely on it.
TEST(WavefrontGather, RaysDoNotDependOnEachOther)
{
  SceneDescription d = rooms::furnishedRoom(0.6);
  d.materials[0].specular = 0.2;
  d.materials[0].roughness = 0.3;
  const Scene scene(d);
  const Emission emission(scene);
  const Settings settings;
  const GatherContext gathering(scene, emission, settings, true);
  LightVertices vertices = traceTrajectories(scene, emission, {}, 0, 0, 500);
  gathering.pilot().annotate(vertices);
  const GatherPool pool{&vertices, 500};
  const VertexSet at = places(Scene(rooms::furnishedRoom(0.6)), 60);
  WavefrontGather all(gathering, pool);
  auto add = [&](WavefrontGather& wave, std::size_t i) {
    const Sensor sensor(placeReceiver(scene, at.position(i), at.normal(i)));
    return i % 3 ? wave.gather(sensor, {0.05, true}, stream(i)) : wave.indirectLight(sensor, false, stream(i));
  };
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_EQ(add(all, i), i);
  all.run();
  double sum = 0;
  WavefrontGather one(gathering, pool);
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    one.clear();
    add(one, i);
    one.run();
    EXPECT_EQ(one.light(0)[0], all.light(i)[0]) << i;
    sum += one.light(0)[0];
  }
  EXPECT_GT(sum, 0);
}
