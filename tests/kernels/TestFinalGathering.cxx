// SPDX-License-Identifier: BSD-3-Clause
// The parts of final gathering, one by one.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/gathering/HitAccumulation.h"

using namespace kalos;

namespace
{
constexpr int trajectories = 1024;

// A plane of 8 x 8 receivers in a room, and what gathers for it.
struct Gathered
{
  Scene scene;
  Settings settings;
  ReceiverDirectLight direct;
  Emission emission;
  GatherContext context;
  GatherPlan plan;
  GatherHitTracer tracer;
  LightVertices vertices;
  Tally tally;

  explicit Gathered(const SceneDescription& d, double height = 0.75)
      : scene(d),
        direct(this->scene, plane(height), this->settings),
        emission(this->scene),
        context(this->scene, this->emission, this->settings, this->direct.shadows()),
        plan(this->scene, this->direct.sensors(), this->settings),
        tracer(this->context, this->direct, this->plan, this->settings),
        vertices(traceTrajectories(this->scene, this->emission, this->settings.walks(), 0, 0, trajectories)),
        tally(this->scene, 64, 1)
  {
    Workers workers(1, {}, Ranks());
    this->direct.prepare(workers, this->tally);
    this->context.pilot().annotate(this->vertices);
  }

  static Receivers plane(double height)
  {
    Receivers r;
    for (int i = 0; i < 64; ++i)
    {
      r.points.push_back({0.4 + 0.6 * (i / 8), 0.4 + 0.6 * (i % 8), height});
      r.normals.push_back({0, 0, 1});
    }
    return r;
  }

  GatherRound round() const { return this->plan.round({&this->vertices, trajectories}, 0, 0, 64); }
};

// Cells with the hits of a tile, shaded.
CellShading shade(Gathered& g, GatherHits& hits)
{
  g.tracer.trace(0, g.round(), hits, g.tally);
  CellShading cells(g.context, g.round());
  cells.add(hits.hits);
  cells.reserve();
  for (std::size_t part = 0; part < cells.parts(); ++part)
    cells.shade(part);
  return cells;
}
}  // namespace

TEST(GatherPlan, SmallGroupsSendAsManyRays)
{
  const Gathered g(rooms::litRoom(0.5));
  EXPECT_EQ(g.plan.trajectoriesPerRay(), 32);  // 16 x 16 < 8 x 64
  const GatherRound round = g.round();
  EXPECT_EQ(round.rays, 32);
  const std::vector<ReceiverGroup> groups = g.plan.groups(0, g.tally);
  ASSERT_EQ(groups.size(), 2u);  // a tile has 32 receivers
  EXPECT_EQ(g.plan.raysOfEach(groups[0], round.rays), 32);
  ReceiverGroup three;
  for (std::size_t r = 0; r < 3; ++r)
    three.add(r, g.direct.sensors()[r]);
  EXPECT_EQ(g.plan.raysOfEach(three, round.rays), 128);  // as four would
  EXPECT_TRUE(g.plan.loners(0, g.tally).empty());
}

TEST(GatherPlan, ReceiversInTheNarrowestGapsAreLoners)
{
  SceneDescription d = rooms::litRoom(0.5);
  rooms::addQuad(d, {0.4 + 3e-7, 0, 0}, {0, 2, 0}, {0, 0, 2}, 0);  // a screen beside three of the receivers
  const Gathered g(d);
  std::size_t together = 0, alone = 0;
  for (std::size_t tile = 0; tile < 2; ++tile)
  {
    alone += g.plan.loners(tile, g.tally).size();
    for (const ReceiverGroup& group : g.plan.groups(tile, g.tally))
      together += static_cast<std::size_t>(group.size());
  }
  EXPECT_EQ(alone, 3u);
  EXPECT_EQ(together + alone, 64u);
}

// Every ray of a closed room ends on one of its surfaces.
TEST(GatherHitTracer, HitsLieOnSurfaces)
{
  Gathered g(rooms::furnishedRoom(0.5));
  GatherHits found;
  g.tracer.trace(0, g.round(), found, g.tally);
  EXPECT_EQ(found.hits.size(), 32u * 32u);
  EXPECT_EQ(found.ends, (std::vector<std::size_t>{512, 1024}));
  for (const SurfaceHit& hit : found.hits)
  {
    const Vec3 p{hit.position[0], hit.position[1], hit.position[2]};
    const Sensor at = sensorAt(g.scene, hit);
    EXPECT_LT(length(at.position - p), 1e-5);
    EXPECT_LT(std::abs(dot(at.position - g.scene.corner(hit.side / 2, 0), at.normal)), 1e-12);
    EXPECT_LT(hit.finder, 16);
  }
  EXPECT_EQ(g.tally.total(g.plan.groups(0, g.tally)[0].receiver(0), 0)[0], 0);  // all is left to the cells
}

// What ends on gloss lights its receiver at once.
TEST(GatherHitTracer, GlossyHitsAreFollowed)
{
  SceneDescription d = rooms::litRoom(0.5);
  d.materials.push_back(d.materials[0]);
  d.materials.back().specular = 0.3;
  d.materials.back().roughness = 0.5;
  const double area = 25.0 / 6 / 25;  // of a face, over that of the room
  for (std::size_t t = 0; t < 2; ++t)
    d.triangleMaterial[t + 6] = 1;  // the ceiling
  Gathered g(d);
  GatherHits found;
  g.tracer.trace(0, g.round(), found, g.tally);
  const auto followed = static_cast<double>(32 * 32 - found.hits.size());
  EXPECT_GT(followed, area * 32 * 32);  // what is above takes more than its share of the rays
  EXPECT_LT(followed, 0.7 * 32 * 32);
  EXPECT_GT(g.tally.total(g.plan.groups(0, g.tally)[0].receiver(0), 0)[0], 0);
}

// In a white furnace all cells are lit alike: their mean within 5 standard deviations of 3 %, as 1024 trajectories
// have.
TEST(CellShading, CellsOfAFurnaceAreLitAlike)
{
  Gathered g(rooms::furnace(0.5, 100));
  GatherHits found;
  const CellShading cells = shade(g, found);
  EXPECT_GT(cells.cells(), 100u);
  EXPECT_LT(cells.cells(), found.hits.size());
  double sum = 0;
  for (const SurfaceHit& hit : found.hits)
  {
    EXPECT_LT(hit.cell, cells.cells());
    sum += cells.indirect(hit)[0];
  }
  EXPECT_NEAR(sum / static_cast<double>(found.hits.size()), 200, 0.15 * 200);
}

// Where every cell has the same light, receivers get what rays find: exitance and reflected light.
TEST(HitAccumulation, ReceiversGetWhatTheirRaysFind)
{
  Gathered g(rooms::furnace(0.5, 100));
  GatherHits found;
  const CellShading cells = shade(g, found);
  InterpolationCheck check;
  check.reset(2, 1);
  const BrightSpots spots(g.context);
  HitAccumulation(g.context, g.direct, g.plan, spots).add(0, found, cells, g.tally, check.of(0, 0));
  double sum = 0;
  for (const ReceiverGroup& group : g.plan.groups(0, g.tally))
    for (int k = 0; k < group.size(); ++k)
    {
      const std::size_t r = group.receiver(k);
      ASSERT_TRUE(g.direct.exactMeshes(r));
      EXPECT_EQ(g.tally.direct(r, 0)[0], 0);
      EXPECT_GT(g.tally.largest(r, 0), 0);
      sum += g.tally.total(r, 0)[0] / trajectories / 32;
    }
  double indirect = 0;
  for (const SurfaceHit& hit : found.hits)
    indirect += cells.indirect(hit)[0] / static_cast<double>(found.hits.size());
  EXPECT_NEAR(sum, 0.5 * indirect, 0.02 * sum);  // of the 200 lx about each hit
  EXPECT_EQ(check.of(0, 0).rays, 1024);
  EXPECT_GT(check.of(0, 0).shared, 100);
}

// A hit that represents its cell has the cell's own estimate; others of the cell do not.
TEST(InterpolationCheck, RepresentativesHaveNoExcess)
{
  Gathered g(rooms::furnishedRoom(0.5));
  GatherHits found;
  const CellShading cells = shade(g, found);
  InterpolationCheck check;
  check.reset(1, 1);
  WavefrontGather own(g.context, cells.round().pool);
  for (const SurfaceHit& hit : found.hits)
    cells.estimate(hit, own);
  own.run();
  double worst = 0, expected = 0;
  std::size_t same = 0, shared = 0;
  InterpolationProbes probes(g.context, cells, check.of(0, 0));
  for (std::size_t i = 0; i < found.hits.size(); ++i)
  {
    const double difference = cells.indirect(found.hits[i])[0] - own.light(i)[0];
    same += difference == 0;
    worst = std::max(worst, std::abs(difference));
    probes.note(found.hits[i], 0.25);
    shared += cells.isShared(found.hits[i]);
    if (cells.isShared(found.hits[i]) && shared % 64 == 32)
      expected += 64 * 0.25 * 0.5 * difference;
  }
  probes.finish();
  EXPECT_GE(same, cells.cells());
  EXPECT_LT(same, found.hits.size());
  EXPECT_GT(worst, 0);
  EXPECT_EQ(check.of(0, 0).shared, static_cast<double>(shared));
  EXPECT_NE(expected, 0);
  EXPECT_NEAR(check.of(0, 0).excess, expected, 1e-9 * std::abs(expected));
}
