// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "Solids.h"
#include "remesh/SurfaceRemesh.h"
#include "repair/SurfaceRepair.h"
#include "singular/EdgeDistance.h"

using namespace kalos::meshing;
using namespace solids;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// A room with a table, each wall its own material.
TriangleMesh furnishedRoom()
{
  TriangleMesh mesh;
  addBox(mesh, {0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 3}, true);
  addTurnedBox(mesh, {2, 2.5, 0}, {1.6, 0.8, 0.75}, 0.4);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.material[t] = static_cast<std::uint32_t>(t / 2);
  repair(mesh, {});
  return mesh;
}

std::map<std::uint32_t, double> areaByMaterial(const TriangleMesh& mesh)
{
  std::map<std::uint32_t, double> result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    result[mesh.material[t]] += 0.5 * norm(doubledArea(mesh, mesh.triangles[t]));
  return result;
}

/// Largest distance of a material's corners from the plane that the material had before, and whether all face as
/// before.
void expectSamePlanes(const TriangleMesh& before, const TriangleMesh& after)
{
  std::map<std::uint32_t, std::pair<Point, Point>> planes;
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
    planes[before.material[t]] = {before.points[before.triangles[t][0]],
                                  unit(doubledArea(before, before.triangles[t]))};
  double worst = 0.0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t)
  {
    const auto& [origin, normal] = planes[after.material[t]];
    for (const std::uint32_t corner : after.triangles[t])
      worst = std::max(worst, std::abs(dot(after.points[corner] - origin, normal)));
    EXPECT_GT(dot(doubledArea(after, after.triangles[t]), normal), 0.0);
  }
  EXPECT_LT(worst, 1e-9);
}
}  // namespace

TEST(SurfaceRemesh, KeepsPlanesAreasAndMaterials)
{
  for (double length : {0.1, 0.5, 2.0})
  {
    const TriangleMesh before = furnishedRoom();
    TriangleMesh after = before;
    RemeshSettings settings;
    settings.edgeLength = length;
    const RemeshReport report = remesh(after, settings);
    EXPECT_NEAR(report.areaAfter, report.areaBefore, 1e-9 * report.areaBefore);
    EXPECT_EQ(report.patches, 12u);
    const auto was = areaByMaterial(before), is = areaByMaterial(after);
    ASSERT_EQ(was.size(), is.size());
    for (const auto& [material, value] : was)
      EXPECT_NEAR(is.at(material), value, 1e-9) << material;
    expectSamePlanes(before, after);
    for (std::size_t t = 0; t < after.triangles.size(); ++t)
      EXPECT_EQ(after.material[t], after.origin[t] / 2);
    if (length == 0.1)
    {
      EXPECT_GT(report.minimumAngle, 15 * pi / 180);
      EXPECT_LT(report.smallAngles, 0.001);
      EXPECT_NEAR(report.mean, length, 0.15 * length);
      EXPECT_LT(report.longest, 1.7 * length);
      EXPECT_GT(report.histogram[3] + report.histogram[4], 2 * report.trianglesAfter * 3 / 2 * 4 / 10);
    }
    // A coarse mesh again from the fine one.
    if (length == 0.1)
    {
      settings.edgeLength = 1.0;
      const RemeshReport coarse = remesh(after, settings);
      EXPECT_LT(coarse.trianglesAfter, report.trianglesAfter / 20);
      expectSamePlanes(before, after);
    }
  }
}

TEST(SurfaceRemesh, GradesTowardsSingularEdges)
{
  TriangleMesh mesh = furnishedRoom();
  const TriangleMesh before = mesh;
  RemeshSettings settings;
  settings.edgeLength = 0.4;
  settings.smallest = 0.05;
  settings.grading = 0.3;
  const RemeshReport report = remesh(mesh, settings);
  EXPECT_NEAR(report.areaAfter, report.areaBefore, 1e-9 * report.areaBefore);
  expectSamePlanes(before, mesh);
  const EdgeDistance edges(findSingularEdges(before, {}));
  double nearSum = 0, farSum = 0;
  int nearCount = 0, farCount = 0;
  for (const Triangle& t : mesh.triangles)
  {
    const Point centre = (1.0 / 3) * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]);
    const double distance = edges.nearest(centre).distance;
    const double length = std::sqrt(0.5 * norm(doubledArea(mesh, t)) / (std::sqrt(3.0) / 4));
    if (distance < 0.05)
      nearSum += length, ++nearCount;
    if (distance > 1.2)
      farSum += length, ++farCount;
  }
  EXPECT_NEAR(nearSum / nearCount, 0.05, 0.02);
  EXPECT_NEAR(farSum / farCount, 0.4, 0.1);
}

TEST(SurfaceRemesh, RefinesWhereCellsWantIt)
{
  TriangleMesh mesh = furnishedRoom();
  RemeshSettings settings;
  settings.edgeLength = 0.5;
  settings.wanted.assign(24, 10.0);
  settings.wanted[0] = settings.wanted[1] = 0.1;
  remesh(mesh, settings);
  const auto count = [&](std::uint32_t material) {
    return std::count(mesh.material.begin(), mesh.material.end(), material);
  };
  EXPECT_GT(count(0), 10 * count(1));
}

TEST(SurfaceRemesh, CanBeStoppedWithinAnIteration)
{
  TriangleMesh mesh = furnishedRoom();
  const TriangleMesh before = mesh;
  RemeshSettings settings;
  settings.edgeLength = 0.03;
  settings.iterations = 1;
  double last = -1.0;
  int same = 0;
  const auto stopAtTheSecondSame = [&](double share) {
    same = share == last ? same + 1 : 0;
    last = share;
    return same < 2;
  };
  EXPECT_THROW(remesh(mesh, settings, stopAtTheSecondSame), Stopped);
  EXPECT_LT(last, 0.1);
  EXPECT_EQ(mesh.points, before.points);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(SurfaceRemesh, LengthsThatTheMemoryCannotHoldAreRefused)
{
  TriangleMesh mesh = furnishedRoom();
  RemeshSettings settings;
  settings.edgeLength = 1e-5;
  settings.maximumTriangles = std::size_t(-1);
  try
  {
    remesh(mesh, settings);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
}

TEST(SurfaceRemesh, BadInput)
{
  for (double length : {0.0, -1.0, double(NAN), double(INFINITY), 1e-7})
  {
    TriangleMesh mesh = furnishedRoom();
    const std::size_t before = mesh.triangles.size();
    RemeshSettings settings;
    settings.edgeLength = length;
    EXPECT_THROW(remesh(mesh, settings), std::invalid_argument) << length;
    EXPECT_EQ(mesh.triangles.size(), before);
  }
  TriangleMesh empty;
  RemeshSettings settings;
  settings.edgeLength = 1;
  EXPECT_THROW(remesh(empty, settings), std::invalid_argument);
  TriangleMesh one;
  addTriangle(one, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(remesh(one, settings).areaAfter, 0.5, 1e-12);
  EXPECT_THROW(remesh(one, settings, [](double) { return false; }), Stopped);
}
