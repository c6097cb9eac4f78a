// SPDX-License-Identifier: BSD-3-Clause
// Visibility where rounding matters: from tilted surfaces anywhere about the centre of coordinates, in gaps and at
// edges. The judge tests all triangles, in double precision.
#include <gtest/gtest.h>

#include "Poses.h"
#include "Student.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/kernel/PairKernel.h"
#include "sampling/Warp.h"
#include "scene/RayBatch.h"

using namespace poses;

namespace
{
struct Place
{
  std::uint32_t triangle;
  Vec3 p, n;
};

// A point of a triangle that is not nearer to its border than a hundredth, on one of its sides.
Place placeOn(const Scene& scene, std::uint32_t t, RandomStream& random)
{
  double u, v;
  uniformTriangle(random.next(), random.next(), u, v);
  const Vec3 a = scene.corner(t, 0);
  u = 0.01 + 0.97 * u;
  v = 0.01 + 0.97 * v;
  const Vec3 n = random.next() < 0.5 ? scene.normal(t) : -scene.normal(t);
  return {t, a + u * (scene.corner(t, 1) - a) + v * (scene.corner(t, 2) - a), n};
}

// Whether a triangle other than those of the ends stands between them; `undecided` where one nearly does.
bool judge(const Scene& scene, const Place& a, const Place& b, bool& undecided)
{
  const Vec3 d = b.p - a.p;
  bool hidden = false;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
  {
    if (t == a.triangle || t == b.triangle)
      continue;
    const Vec3 o = a.p - scene.corner(t, 0), n = scene.normal(t);
    const Vec3 u = scene.corner(t, 1) - scene.corner(t, 0), v = scene.corner(t, 2) - scene.corner(t, 0);
    const double at = -dot(n, o) / dot(n, d), square = dot(cross(u, v), cross(u, v));
    const Vec3 p = o + at * d;
    const double atU = dot(cross(p, v), cross(u, v)) / square, atV = dot(cross(u, p), cross(u, v)) / square;
    const double inside = std::min({atU, atV, 1 - atU - atV}), between = std::min(at, 1 - at);
    constexpr double clear = 1e-3;
    const bool coplanar = std::abs(dot(n, o)) < 1e-9 * scene.size() || std::abs(dot(n, o + d)) < 1e-9 * scene.size();
    undecided = undecided || (!coplanar && std::abs(inside) < clear && between > -clear) ||
                (!coplanar && inside > 0 && std::abs(between) < clear);
    hidden = hidden || (!coplanar && inside > clear && between > clear);
  }
  return hidden;
}

struct Count
{
  int pairs = 0, hidden = 0, wrong = 0;
};

// Pairs of places that face each other, by packets as vertices are scored, by packets of ray batches, and alone.
Count compare(const Scene& scene, int pairs, std::uint64_t seed)
{
  RandomStream random(seed, 0, Purpose::Selection, 0);
  auto any = [&] {
    const double triangles = static_cast<double>(scene.data().triangles.size());
    return placeOn(scene, static_cast<std::uint32_t>(random.next() * triangles), random);
  };
  Count count;
  for (int i = 0; i < pairs; ++i)
  {
    const Place a = any(), b = any();
    const Vec3 d = b.p - a.p;
    bool undecided = !(dot(d, a.n) > 0.01 * length(d) && dot(d, b.n) < -0.01 * length(d));
    const bool hidden = judge(scene, a, b, undecided);
    if (undecided)
      continue;
    VertexSet one;
    one.add(scene.anchor(b.triangle, b.p, b.n), uniformBands(1));
    // As a receiver, which does not know its surface, or as a place that a gather ray has found.
    const Sensor sensor(i % 2 ? placeReceiver(scene, a.p, a.n) : scene.anchor(a.triangle, a.p, a.n));
    SegmentPacket packet;
    const int first = 0;
    fillPacket(one, sensor, &first, 1, packet);
    std::vector<ShadowRay> shadow{{sensor.anchor, one.anchor(0), false}};
    shadowTogether(scene.rays(), shadow);
    ++count.pairs;
    count.hidden += hidden;
    count.wrong += (scene.rays().occluded(packet, 1) == 1) != hidden || shadow[0].hidden != hidden ||
                   scene.rays().occluded(sensor.anchor, scene.anchor(b.triangle, b.p, b.n)) != hidden;
  }
  return count;
}

void expectNoneWrong(const SceneDescription& d, int pairs, const std::string& what)
{
  const Scene scene(d);
  const Count count = compare(scene, pairs, 7);
  EXPECT_EQ(count.wrong, 0) << what << ": of " << count.pairs << ", " << count.hidden << " of them hidden";
  EXPECT_GT(count.pairs, pairs / 50) << what;
}
}  // namespace

// The furnished room with tilted panels, as it is and under rotations, translations and scales, finer, and with the
// centre of coordinates on a panel, in a box, at a corner.
TEST(Rounding, EveryPairSeesWhatTheJudgeSees)
{
  const SceneDescription room = tiltedRoom(0.6);
  for (std::uint64_t turn = 0; turn < 6; ++turn)
    for (const double scale : {1e-3, 1.0, 1e3})
      for (const double away : {0.0, 0.1, 1000.0, 1e6})
      {
        Pose pose;
        if (turn > 0)
          pose.axes = randomAxes(turn);
        pose.scale = scale;
        pose.shift = {away, -away, 0.5 * away};
        if (away > 1e5 * scale)  // double precision has no digits left for a thousandth of the room
          continue;
        expectNoneWrong(posed(room, pose), 4000,
                        std::to_string(scale) + " m, " + std::to_string(away) + " m, turn " + std::to_string(turn));
      }
  for (const Vec3& centre : {Vec3{2.5, 2.5, 2.5}, Vec3{1.6, 1.7, 0.7}, Vec3{4.2, 0.8, 1.5}, Vec3{0, 0, 0}})
    for (std::uint64_t turn = 1; turn < 4; ++turn)
    {
      SceneDescription d = turn == 2 ? finer(room) : room;
      recentre(d, centre, {0, 0, 0}, {5, 5, 5});
      Pose pose;
      pose.axes = randomAxes(turn);
      expectNoneWrong(posed(d, pose), 4000, "centre " + std::to_string(centre.x) + ", turn " + std::to_string(turn));
    }
}

// Panels of all normals about the centre, small and large rooms; a tessellated ball and needles.
TEST(Rounding, BodiesInTheMiddleSeeTheRoom)
{
  for (const double room : {4.0, 10.0, 100.0})
    for (const double side : {0.05, 0.3, 1.0})
    {
      SceneDescription d;
      const auto grey = rooms::addMaterial(d, 0.5);
      rooms::addBox(d, {-room / 2, -room / 2, -room / 5}, {room, room, 0.4 * room}, grey, true);
      const double golden = pi * (3 - std::sqrt(5.0));
      for (int i = 0; i < 24; ++i)  // a fan that does not touch itself
      {
        const double z = 1 - (2 * i + 1) / 24.0, r = std::sqrt(1 - z * z);
        const Vec3 n{r * std::cos(golden * i), r * std::sin(golden * i), z};
        addPanel(d, 2 * side * n, n, 0.3 * side, grey);
      }
      expectNoneWrong(d, 20000, "fan of " + std::to_string(side) + " m in " + std::to_string(room) + " m");
    }
  for (const int columns : {16, 400})  // and needles
  {
    SceneDescription d;
    const auto grey = rooms::addMaterial(d, 0.5);
    rooms::addBox(d, {-5, -5, -2}, {10, 10, 4}, grey, true);
    const auto first = static_cast<std::uint32_t>(d.points.size());
    for (int ring = 0; ring <= 6; ++ring)  // a vase
      for (int k = 0; k < columns; ++k)
      {
        const double phi = 2 * pi * k / columns, radius = 0.1 + 0.05 * std::sin(ring);
        d.points.push_back({radius * std::cos(phi), radius * std::sin(phi), 0.1 * ring - 0.3});
      }
    for (int ring = 0; ring < 6; ++ring)
      for (int k = 0; k < columns; ++k)
      {
        auto at = [&](int i, int j) { return first + static_cast<std::uint32_t>(i * columns + j % columns); };
        d.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
        d.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
      }
    d.triangleMaterial.resize(d.triangles.size(), grey);
    expectNoneWrong(d, 40000, "vase of " + std::to_string(columns) + " columns");
  }
}

// A panel of 0.3 m in a black room of 10 m x 10 m x 4 m, lit by one lamp along its normal, at the centre of coordinates
// and beside it: its light on the walls is an integral over the panel, here by the midpoint rule on 60 x 60 points. All
// that compensated and local find; 7 degrees of freedom or more, 96 values: 12 standard errors, 7e-4. The values share
// their trajectories, so that their common error is what 262144 trajectories leave: below 1 %.
TEST(Rounding, ABrightPanelInTheMiddleIsSeen)
{
  for (const double beside : {0.0, 0.2})
    for (const Vec3& n : {normalized({0.609, 0.469, 0.639}), normalized({-0.2, 0.9, -0.4})})
    {
      SceneDescription d;
      rooms::addBox(d, {-5, -5, -2}, {10, 10, 4}, rooms::addMaterial(d, 0), true);
      const Vec3 centre{beside, 0, 0};
      addPanel(d, centre, n, 0.3, rooms::addMaterial(d, 0.8));
      Luminaire lamp;
      lamp.position = centre + 1.2 * n;
      lamp.axis = -n;
      lamp.flux = 2000;
      d.luminaires.push_back(lamp);
      Receivers r;
      std::vector<double> truth;
      for (int i = 0; i < 12; ++i)
      {
        const Vec3 p = i % 2 ? Vec3{n.x > 0 ? 5.0 : -5.0, -3 + 0.5 * i, 1.4} : Vec3{-3 + 0.5 * i, 5, -1.4};
        const Vec3 facing = i % 2 ? Vec3{n.x > 0 ? -1.0 : 1.0, 0, 0} : Vec3{0, -1, 0};
        if (!(dot(p - lamp.position, n) > 0))  // the lamp would light it
          continue;
        double sum = 0;
        constexpr int steps = 60;
        const Frame f(n);
        for (int j = 0; j < steps; ++j)
          for (int k = 0; k < steps; ++k)
          {
            const Vec3 y = centre + 0.3 * ((j + 0.5) / steps - 0.5) * f.s + 0.3 * ((k + 0.5) / steps - 0.5) * f.t;
            const Vec3 in = lamp.position - y, out = p - y;
            const double e = 2000 / pi * std::pow(dot(in, n), 2) / std::pow(dot(in, in), 2);
            const double g = std::max(0.0, dot(out, n)) * std::max(0.0, -dot(out, facing)) / std::pow(dot(out, out), 2);
            sum += 0.8 / pi * e * g * 0.09 / (steps * steps);
          }
        r.points.push_back(p);
        r.normals.push_back(facing);
        truth.push_back(sum);
      }
      for (const Method method : {Method::Local, Method::Compensated})
      {
        Settings s;
        s.method = method;
        s.trajectories = 262144;
        const Result result = solve(Scene(d), r, s);
        for (std::size_t i = 0; i < truth.size(); ++i)
        {
          EXPECT_LT(std::abs(result.illuminance[i] - truth[i]), 12 * result.standardError[i] + 1e-3 * truth[i]) << i;
          EXPECT_LT(result.standardError[i], 0.01 * truth[i] + 1e-6) << i;
        }
        EXPECT_GT(truth.size(), 4u);
      }
    }
}

// Walls from a nanometre to a centimetre thick let nothing through, whichever way they stand: from one side of the room
// to the other, and to points in the air that are a tenth of a millimetre and more before the wall.
TEST(Rounding, ThinWallsDoNotLeak)
{
  for (const double thickness : {1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-2})
    for (std::uint64_t turn = 0; turn < 4; ++turn)
    {
      SceneDescription d = rooms::litRoom(0.5);
      rooms::addQuad(d, {2.4, 0, 0}, {0, 0, 5}, {0, 5, 0}, 0);
      rooms::addQuad(d, {2.4 + thickness, 0, 0}, {0, 5, 0}, {0, 0, 5}, 0);
      Pose pose;
      if (turn > 0)
        pose.axes = randomAxes(turn);
      const Scene scene(posed(d, pose));
      RandomStream random(turn, 0, Purpose::Selection, 0);
      int leaked = 0;
      for (int i = 0; i < 20000; ++i)
      {
        auto place = [&](double x, double facing) {
          const double y = 5 * random.next(), z = 5 * random.next();
          return placeReceiver(scene, pose(Vec3{x, y, z}) - scene.origin(), pose.turned(Vec3{facing, 0, 0}));
        };
        const double before = i % 2 ? 2.4 : std::pow(10, -4 + 4 * random.next());
        const RayAnchor a = place(2.4 - before, 1), b = place(5, -1);
        SegmentPacket packet;
        packet.set(0, a, b);
        leaked += scene.rays().occluded(packet, 1) == 0 || !scene.rays().occluded(a, b);
      }
      EXPECT_EQ(leaked, 0) << thickness << " m, turn " << turn;
    }
}
