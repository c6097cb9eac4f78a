// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Solids.h"
#include "singular/EdgeDistance.h"
#include "singular/SingularEdges.h"

using namespace kalos::meshing;
using namespace solids;

namespace
{
constexpr double pi = 3.14159265358979323846;

struct Found
{
  std::size_t count = 0;
  double length = 0.0;
};

Found found(const Curves& curves, EdgeClass kind)
{
  Found result;
  for (const Curve& c : curves.curves)
  {
    if (c.edge.kind != kind)
      continue;
    ++result.count;
    for (std::size_t i = c.first; i + 1 < c.first + c.count; ++i)
      result.length += norm(curves.points[curves.indices[i + 1]] - curves.points[curves.indices[i]]);
  }
  return result;
}

EdgeSettings everything()
{
  EdgeSettings settings;
  settings.wanted.fill(true);
  return settings;
}

using Polygon = std::vector<std::array<double, 2>>;

Polygon rectangle(const Point& centre, const Point& size, double angle)
{
  Polygon corners;
  for (const auto& [a, b] : {std::array<double, 2>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
  {
    const double x = 0.5 * a * size[0], y = 0.5 * b * size[1];
    corners.push_back(
        {centre[0] + x * std::cos(angle) - y * std::sin(angle), centre[1] + x * std::sin(angle) + y * std::cos(angle)});
  }
  return corners;
}

/// Sutherland and Hodgman's clipping of one convex polygon by another, both counter-clockwise.
Polygon clip(Polygon subject, const Polygon& window)
{
  for (std::size_t i = 0; i < window.size(); ++i)
  {
    const auto a = window[i], b = window[(i + 1) % window.size()];
    const auto height = [&](const std::array<double, 2>& p) {
      return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    };
    Polygon kept;
    for (std::size_t j = 0; j < subject.size(); ++j)
    {
      const auto p = subject[j], q = subject[(j + 1) % subject.size()];
      const double hp = height(p), hq = height(q);
      if (hp >= 0)
        kept.push_back(p);
      if (hp * hq < 0)
        kept.push_back({p[0] + hp / (hp - hq) * (q[0] - p[0]), p[1] + hp / (hp - hq) * (q[1] - p[1])});
    }
    subject = kept;
  }
  return subject;
}

/// The edges expected around shared faces, for the tolerance that was used.
struct Outline
{
  std::size_t sides = 0;  // longer than the shortest contact that is told from none
  double length = 0.0;
  double slack = 1e-4;  // surfaces within the tolerance touch: sides that cross at a small angle do so for longer

  void add(const Polygon& polygon, double tolerance)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto p = polygon[i], q = polygon[(i + 1) % polygon.size()], r = polygon[(i + 2) % polygon.size()];
      const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - q[0], vy = r[1] - q[1];
      const double side = std::hypot(ux, uy), sine = std::abs(ux * vy - uy * vx) / (side * std::hypot(vx, vy));
      sides += side > 4 * tolerance;
      length += side;
      slack += 2 * tolerance * (1 / sine - 1);
    }
  }
};
}  // namespace

TEST(SingularEdges, RoomHasTwelveConcaveEdges)
{
  for (int n : {1, 3, 8})
  {
    TriangleMesh room;
    addBox(room, {0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {0, 0, 3}, true, n);
    const Curves curves = findSingularEdges(room, everything());
    EXPECT_EQ(found(curves, EdgeClass::Concave).count, 12u);
    EXPECT_NEAR(found(curves, EdgeClass::Concave).length, 48.0, 1e-9);
    for (EdgeClass kind : {EdgeClass::Convex, EdgeClass::Border, EdgeClass::NonManifold, EdgeClass::Contact})
      EXPECT_EQ(found(curves, kind).count, 0u) << static_cast<int>(kind);
    for (const Curve& c : curves.curves)
    {
      const bool concave = c.edge.kind == EdgeClass::Concave;
      EXPECT_NEAR(c.edge.front, concave ? pi / 2 : pi, 1e-9);
      EXPECT_NEAR(c.edge.back, concave ? 3 * pi / 2 : pi, 1e-9);
      EXPECT_NEAR(c.edge.severity, concave ? 0.25 : 0.0, 1e-9);
    }
  }
}

TEST(SingularEdges, ConvexBoxHasNone)
{
  TriangleMesh box;
  addTurnedBox(box, {1, 2, 3}, {0.5, 0.7, 0.9}, 0.3, 4);
  const Curves curves = findSingularEdges(box, {});
  EXPECT_TRUE(curves.curves.empty());
  EXPECT_EQ(curves.report.edges[static_cast<int>(EdgeClass::Convex)], 48u);
  // Seen from inside too, the same edges are concave.
  EdgeSettings settings;
  settings.bothSides = true;
  EXPECT_EQ(found(findSingularEdges(box, settings), EdgeClass::Concave).count, 12u);
}

TEST(SingularEdges, SeverityIsTheKernelAtUnitDistance)
{
  for (double degrees : {20.0, 60.0, 90.0, 135.0, 175.0})
  {
    const double angle = degrees * pi / 180;
    TriangleMesh fold;
    const Point wall{std::cos(angle), 0, std::sin(angle)};
    addTriangle(fold, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    addTriangle(fold, {0, 0, 0}, {0, 1, 0}, wall);
    const Curves curves = findSingularEdges(fold, {});
    ASSERT_EQ(curves.curves.size(), 1u) << degrees;
    EXPECT_NEAR(curves.curves[0].edge.front, angle, 1e-9);
    // cosθ cosθ' / d² of two points at distance 1 from the edge.
    const double distance = norm(wall - Point{1, 0, 0});
    const double cosine = wall[2] / distance;
    EXPECT_NEAR(curves.curves[0].edge.severity, cosine * cosine / (distance * distance), 1e-9);
  }
}

TEST(SingularEdges, FoldsThatFaceOppositeWaysCountByTheirNarrowSide)
{
  TriangleMesh fold;
  addQuad(fold, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addQuad(fold, {0, 0, 0}, {0, 0, 1}, {0, 1, 0});  // its back looks over the other one
  const Curves curves = findSingularEdges(fold, {});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].edge.kind, EdgeClass::Concave);
  EXPECT_NEAR(curves.curves[0].edge.front, pi / 2, 1e-9);
  EXPECT_EQ(curves.report.inconsistent, 1u);
}

TEST(SingularEdges, ThreeWallsAtAnEdgeAreNonManifold)
{
  TriangleMesh walls;
  addQuad(walls, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addQuad(walls, {0, 0, 0}, {0, 1, 0}, {-1, 0, 0});
  addQuad(walls, {0, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const Curves curves = findSingularEdges(walls, {});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].edge.kind, EdgeClass::NonManifold);
  EXPECT_NEAR(curves.curves[0].edge.front, pi / 2, 1e-9);
  EXPECT_NEAR(curves.curves[0].edge.severity, 0.25, 1e-9);
}

TEST(SingularEdges, ThinPanelAndCoplanarOverlapHaveNone)
{
  TriangleMesh mesh;
  // A panel of zero thickness, both fronts outwards, and a rug that lies on a floor.
  addQuad(mesh, {0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  addQuad(mesh, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 2);
  addQuad(mesh, {-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, 3);
  addQuad(mesh, {0.1, 0.2, 0}, {1, 0.3, 0}, {-0.3, 1, 0});
  EXPECT_TRUE(findSingularEdges(mesh, {}).curves.empty());
}

TEST(SingularEdges, CrossingPanelsMeetInAContact)
{
  TriangleMesh mesh;
  addQuad(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 5);
  addQuad(mesh, {0.1, -0.5, -1}, {0, 1, 0}, {1, 0, 2}, 3);
  const Curves curves = findSingularEdges(mesh, {});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].edge.kind, EdgeClass::Contact);
  EXPECT_NEAR(found(curves, EdgeClass::Contact).length, 1.0, 1e-9);
  EXPECT_NEAR(curves.curves[0].edge.front, std::atan2(2, 1), 1e-9);
}

TEST(SingularEdges, TJunctions)
{
  // Floor and wall whose corners do not match along their common edge, and two floors likewise: no edge there.
  TriangleMesh mesh;
  addQuad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
  addQuad(mesh, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 3);
  addQuad(mesh, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5);
  const Curves curves = findSingularEdges(mesh, {});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].edge.kind, EdgeClass::Contact);
  EXPECT_NEAR(found(curves, EdgeClass::Contact).length, 1.0, 1e-9);
}

// A room with towers of boxes turned at random: 12 edges of the room; a box on the floor has 4 contacts; between two
// boxes the contact is the outline of the part that their faces share. Exact but for the tolerance: a side shorter than
// four of it is a point, and an end is known to a few of it over the sine of the angle there.
TEST(SingularEdges, RandomStacksAreFoundExactly)
{
  std::mt19937 random(20231);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 40; ++trial)
  {
    TriangleMesh mesh;
    const int n = trial % 10 == 9 ? 20 : 1 + trial % 3;
    addBox(mesh, {0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}, true, n);
    std::vector<Polygon> shared;
    for (int tower = 0; tower < 4; ++tower)
    {
      Point base{2.5 + 4 * (tower % 2), 2.5 + 4 * (tower / 2), 0};
      Polygon below = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
      for (int level = 0; level < 3; ++level)
      {
        const Point size{0.4 + uniform(random), 0.4 + uniform(random), 0.3 + uniform(random)};
        const double angle = 2 * pi * uniform(random);
        addTurnedBox(mesh, base, size, angle, n);
        const Polygon foot = rectangle(base, size, angle);
        shared.push_back(clip(foot, below));
        below = foot;
        base = base + Point{0.3 * uniform(random), 0.3 * uniform(random), size[2]};
      }
    }
    if (trial % 2)
      moveAside(mesh, uniform(random), {10 * uniform(random), 0, -20 * uniform(random)});
    const Curves curves = findSingularEdges(mesh, {});
    Outline contacts;
    for (const Polygon& polygon : shared)
      contacts.add(polygon, curves.report.tolerance);
    EXPECT_LT(contacts.slack, 0.1) << trial;
    EXPECT_EQ(found(curves, EdgeClass::Concave).count, 12u) << trial;
    EXPECT_NEAR(found(curves, EdgeClass::Concave).length, 108.0, 1e-6) << trial;
    EXPECT_EQ(found(curves, EdgeClass::Contact).count, contacts.sides) << trial;
    EXPECT_NEAR(found(curves, EdgeClass::Contact).length, contacts.length, contacts.slack) << trial;
    EXPECT_EQ(found(curves, EdgeClass::NonManifold).count, 0u) << trial;
    for (const Curve& c : curves.curves)
      EXPECT_NEAR(c.edge.front, pi / 2, 1e-6) << trial;
  }
}

TEST(SingularEdges, DistanceToTheNearest)
{
  TriangleMesh room;
  addBox(room, {0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {0, 0, 3}, true, 3);
  const EdgeDistance distance(findSingularEdges(room, {}));
  EXPECT_NEAR(distance.nearest({2.5, 0.3, 0}).distance, 0.3, 1e-12);
  EXPECT_NEAR(distance.nearest({2.5, 0.3, 0.4}).distance, 0.5, 1e-12);
  EXPECT_NEAR(distance.nearest({-3, -4, 2}).distance, 5, 1e-12);
  EXPECT_TRUE(std::isinf(EdgeDistance(Curves()).nearest({0, 0, 0}).distance));
}

TEST(SingularEdges, BadInput)
{
  TriangleMesh empty;
  EXPECT_THROW(findSingularEdges(empty, {}), std::invalid_argument);
  TriangleMesh bad;
  addTriangle(bad, {0, 0, 0}, {1, 0, 0}, {0, NAN, 0});
  EXPECT_THROW(findSingularEdges(bad, {}), std::invalid_argument);
  TriangleMesh one;
  addTriangle(one, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(findSingularEdges(one, everything()).report.edges[static_cast<int>(EdgeClass::Border)], 3u);
  TriangleMesh line;
  addTriangle(line, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  addTriangle(line, {1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(findSingularEdges(line, {}).report.degenerate, 2u);
  EXPECT_THROW(findSingularEdges(one, {}, [](double) { return false; }), Stopped);
}

TEST(SingularEdges, CoincidentTrianglesTakeNoTime)
{
  TriangleMesh heap;
  for (int i = 0; i < 200000; ++i)
    addTriangle(heap, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(findSingularEdges(heap, {}).report.duplicate, 199999u);
}
