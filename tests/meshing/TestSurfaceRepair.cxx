// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Solids.h"
#include "repair/SurfaceRepair.h"
#include "singular/SingularEdges.h"

using namespace kalos::meshing;
using namespace solids;

namespace
{
TriangleMesh cube(int n = 2)
{
  TriangleMesh mesh;
  addBox(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, false, n);
  return mesh;
}

double volume(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6;
  return sum;
}
/// Volatile, as g++ 12 leaves the rounding out of a vectorised loop.
double asSingle(double value)
{
  const volatile float single = static_cast<float>(value);
  return single;
}
}  // namespace

TEST(SurfaceRepair, MergesTheSoupIntoAClosedSurface)
{
  TriangleMesh mesh = cube();
  moveAside(mesh, 0.7, {100, 50, -3});
  const RepairReport report = repair(mesh, {});
  EXPECT_EQ(report.pointsBefore, 144u);
  EXPECT_EQ(report.pointsAfter, 26u);
  EXPECT_EQ(report.borderBefore, 144u);
  EXPECT_EQ(report.borderAfter, 0u);
  EXPECT_EQ(report.surfaces, 1u);
  EXPECT_EQ(report.turned, 0u);
  EXPECT_NEAR(report.areaAfter, 6.0, 1e-9);
  EXPECT_NEAR(report.areaBefore, 6.0, 1e-9);
}

TEST(SurfaceRepair, TurnsTheMinorityAndKeepsOrigins)
{
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial)
  {
    TriangleMesh mesh = cube(3);
    std::size_t turned = 0;
    for (Triangle& t : mesh.triangles)
    {
      if (random() % 10 < 3)
      {
        std::swap(t[1], t[2]);
        ++turned;
      }
    }
    const RepairReport report = repair(mesh, {});
    EXPECT_EQ(report.turned, turned);
    EXPECT_NEAR(volume(mesh), 1.0, 1e-12);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      EXPECT_EQ(mesh.origin[t], t);
  }
}

TEST(SurfaceRepair, EmittingTrianglesKeepTheirSide)
{
  TriangleMesh mesh = cube();
  RepairSettings settings;
  settings.sided.assign(mesh.triangles.size(), 0);
  settings.sided[3] = 1;
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const Point before = doubledArea(mesh, mesh.triangles[3]);
  const RepairReport report = repair(mesh, settings);
  EXPECT_GT(dot(before, doubledArea(mesh, mesh.triangles[3])), 0.0);
  EXPECT_EQ(report.turned, mesh.triangles.size() - 1);
  EXPECT_TRUE(report.unrepaired.empty());

  // Two that disagree: nothing is turned, both are named.
  mesh = cube();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  settings.sided[9] = 1;
  const RepairReport kept = repair(mesh, settings);
  EXPECT_EQ(kept.turned, 0u);
  ASSERT_EQ(kept.unrepaired.size(), 2u);
  EXPECT_EQ(kept.unrepaired[0].origin, 3u);
}

TEST(SurfaceRepair, DropsDegenerateAndDuplicateTriangles)
{
  TriangleMesh mesh = cube();
  const std::size_t whole = mesh.triangles.size();
  addTriangle(mesh, {0, 0, 0}, {0, 0, 0}, {1, 0, 0});
  addTriangle(mesh, {0, 0, 0}, {0.5, 0, 0}, {1, 0, 0});
  addTriangle(mesh, {0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0});     // coincides with a triangle of the bottom
  addTriangle(mesh, {0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0}, 7);  // so does this, of another material
  const RepairReport report = repair(mesh, {});
  EXPECT_EQ(report.degenerate, 2u);
  EXPECT_EQ(report.duplicate, 1u);
  ASSERT_EQ(report.unrepaired.size(), 1u);
  EXPECT_EQ(report.trianglesAfter, whole + 1);
}

TEST(SurfaceRepair, StitchesCornersThatLieOnBorders)
{
  TriangleMesh mesh;
  addQuad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
  addQuad(mesh, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5);
  addQuad(mesh, {0, 1, 0}, {2, 0, 0}, {0, 1, 0}, 1);
  moveAside(mesh, 0.4, {3, 2, 1});
  const RepairReport report = repair(mesh, {});
  EXPECT_GT(report.splitTriangles, 0u);
  EXPECT_NEAR(report.areaAfter, 4.0, 1e-9);
  // Only the outline is left: 2 + 1 and 5 + 1 on the sides, 2 + 5 below, 1 above.
  EXPECT_EQ(report.borderAfter, 2u + 1 + 5 + 1 + 2 + 5 + 1);
  EXPECT_EQ(report.surfaces, 1u);
}

// Pieces stand where their triangle stood, before what comes later in the file; with keepSides nothing is turned.
TEST(SurfaceRepair, KeepsOrderAndSides)
{
  TriangleMesh mesh;
  addQuad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  addQuad(mesh, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, 3);  // looks the other way
  RepairSettings settings;
  settings.keepSides = true;
  const RepairReport report = repair(mesh, settings);
  EXPECT_GT(report.splitTriangles, 0u);
  EXPECT_EQ(report.turned, 0u);
  EXPECT_TRUE(std::is_sorted(mesh.origin.begin(), mesh.origin.end()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    EXPECT_EQ(doubledArea(mesh, mesh.triangles[t])[2] > 0, mesh.origin[t] < 2) << t;
}

TEST(SurfaceRepair, MoreBorderPointsThanOneSideHolds)
{
  // A large triangle with other triangles' corners on all of its sides.
  TriangleMesh mesh;
  const Point a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  addTriangle(mesh, a, b, c);
  for (int i = 0; i < 4; ++i)
  {
    const double s = i / 4.0, e = (i + 1) / 4.0;
    addTriangle(mesh, a + s * (b - a), {0.5, -1, 0}, a + e * (b - a));
    addTriangle(mesh, b + s * (c - b), {1, 1, 0}, b + e * (c - b));
    addTriangle(mesh, c + s * (a - c), {-1, 0.5, 0}, c + e * (a - c));
  }
  const RepairReport report = repair(mesh, {});
  EXPECT_EQ(report.splitTriangles, 1u);
  EXPECT_EQ(report.borderAfter, 6u);
  EXPECT_NEAR(report.areaAfter, report.areaBefore, 1e-12);
}

TEST(SurfaceRepair, SplitsNonManifoldEdgesAndVertices)
{
  TriangleMesh mesh = cube(1);
  addQuad(mesh, {0, 0, 0}, {-1, 0, 0}, {0, 0, 1});     // a fin on an edge
  addTriangle(mesh, {1, 1, 1}, {2, 1, 1}, {1, 2, 2});  // a flag on a corner
  const RepairReport report = repair(mesh, {});
  EXPECT_EQ(report.nonManifoldBefore, 1u);
  EXPECT_EQ(report.nonManifoldAfter, 0u);
  EXPECT_GT(report.pointsSplit, 0u);
  EXPECT_NEAR(report.areaAfter, report.areaBefore, 1e-12);
}

TEST(SurfaceRepair, BadInput)
{
  TriangleMesh empty;
  EXPECT_THROW(repair(empty, {}), std::invalid_argument);
  TriangleMesh flat;
  addTriangle(flat, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
  EXPECT_THROW(repair(flat, {}), std::invalid_argument);
  TriangleMesh infinite;
  addTriangle(infinite, {0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0});
  EXPECT_THROW(repair(infinite, {}), std::invalid_argument);
  TriangleMesh one;
  addTriangle(one, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(repair(one, {}).borderAfter, 3u);
}

TEST(SurfaceRepair, PanelsThatEmitOnBothSidesKeepBoth)
{
  TriangleMesh panel;
  addQuad(panel, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addQuad(panel, {0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  std::swap(panel.triangles[3], panel.triangles[2]);
  // The diagonals agree, so that the triangles coincide in pairs.
  TriangleMesh plain = panel;
  EXPECT_EQ(repair(plain, {}).trianglesAfter, 2u);
  RepairSettings settings;
  settings.sided.assign(4, 1);
  EXPECT_EQ(repair(panel, settings).trianglesAfter, 4u);
  double up = 0.0, down = 0.0;
  for (const Triangle& t : panel.triangles)
    (doubledArea(panel, t)[2] > 0 ? up : down) += 0.5 * norm(doubledArea(panel, t));
  EXPECT_NEAR(up, 1.0, 1e-12);
  EXPECT_NEAR(down, 1.0, 1e-12);
}

/// Two boards 4 cm apart over ground of 40 km: the gap stays open, and what float32 coordinates write apart still
/// joins.
TEST(SurfaceRepair, TheSiteDoesNotCloseGaps)
{
  for (const auto& [gap, place] : {std::pair{0.04, 0.0}, {0.002, 0.0}, {0.002, 10000.1}})
  {
    TriangleMesh mesh;
    addQuad(mesh, {-20000, -20000, 0}, {40000, 0, 0}, {0, 40000, 0});
    addQuad(mesh, {place - 2.0 - gap / 2, -2, 1}, {2, 0, 0}, {0, 4, 0});
    addQuad(mesh, {place + gap / 2, -2, 1}, {2, 0, 0}, {0, 4, 0});
    const RepairReport report = repair(mesh, {});
    EXPECT_EQ(report.surfaces, 3u) << gap << " at " << place;
    EXPECT_EQ(report.pointsMoved, 0u);
    EXPECT_EQ(report.degenerate, 0u);
  }
}

TEST(SurfaceRepair, RoundedCoordinatesJoin)
{
  for (const double place : {0.0, 100.0, 20000.0})
  {
    TriangleMesh mesh = cube(20);
    // A part of a wide site, turned, and rounded to float32 a little differently in each triangle.
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const Point& p = mesh.points[i];
      const double factor = 1.0 + static_cast<double>(i % 3) * 2e-8;
      mesh.points[i] = {asSingle(factor * (place + 0.8 * p[0] - 0.6 * p[1])),
                        asSingle(factor * (place + 0.6 * p[0] + 0.8 * p[1])), asSingle(factor * p[2])};
    }
    const RepairReport report = repair(mesh, {});
    EXPECT_EQ(report.borderAfter, 0u) << place;
    EXPECT_EQ(report.surfaces, 1u) << place;
  }
}
