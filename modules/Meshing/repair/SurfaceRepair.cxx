// SPDX-License-Identifier: BSD-3-Clause
#include "repair/SurfaceRepair.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesh/SortedSides.h"
#include "mesh/Tolerances.h"

namespace kalos::meshing
{
namespace
{
/// For each triangle the number of the connected surface it is of: connected over edges of two triangles.
std::vector<std::uint32_t> surfacesOf(const TriangleMesh& mesh, std::size_t& count)
{
  std::vector<std::uint32_t> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  const std::vector<Side> sides = sortedSides(mesh);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2)
      parent[find(sides[first].triangle)] = find(sides[first + 1].triangle);
  });
  std::vector<std::uint32_t> surface(mesh.triangles.size());
  std::vector<std::uint32_t> number(mesh.triangles.size(), 0);
  count = 0;
  for (std::uint32_t t = 0; t < surface.size(); ++t)
  {
    const std::uint32_t root = find(t);
    if (number[root] == 0)
      number[root] = static_cast<std::uint32_t>(++count);
    surface[t] = number[root] - 1;
  }
  return surface;
}

/// Areas and emitters for and against turning a consistently oriented surface over.
struct Votes
{
  double turned = 0.0, unturned = 0.0;  // area, m²
  bool sidedTurned = false, sidedUnturned = false;
};

/// Choose the side of each surface.
void chooseSides(TriangleMesh& mesh, const RepairSettings& settings, std::vector<std::uint8_t>& turned,
                 RepairReport& report)
{
  const std::vector<std::uint32_t> surface = surfacesOf(mesh, report.surfaces);
  std::vector<Votes> votes(report.surfaces);
  const auto sided = [&](std::size_t t) {
    return mesh.origin[t] < settings.sided.size() && settings.sided[mesh.origin[t]];
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    Votes& v = votes[surface[t]];
    (turned[t] ? v.turned : v.unturned) += norm(doubledArea(mesh, mesh.triangles[t]));
    if (sided(t))
      (turned[t] ? v.sidedTurned : v.sidedUnturned) = true;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Votes& v = votes[surface[t]];
    const bool disagree = v.sidedTurned && v.sidedUnturned;
    const bool flip = v.sidedTurned || (!v.sidedUnturned && v.turned > v.unturned);
    if (disagree || settings.keepSides ? turned[t] != 0 : flip)
    {
      std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
      turned[t] = !turned[t];
    }
    if (disagree && sided(t) && !settings.keepSides)
      report.unrepaired.push_back({mesh.origin[t], "emitting triangles of one surface face opposite ways; left so"});
    report.turned += turned[t];
  }
}

void nameDuplicates(const TriangleMesh& mesh, std::vector<Unrepaired>& unrepaired)
{
  struct Place
  {
    Triangle corners;
    std::uint32_t material, origin;
  };
  std::vector<Place> places;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    places.push_back({mesh.triangles[t], mesh.material[t], mesh.origin[t]});
    std::sort(places.back().corners.begin(), places.back().corners.end());
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.corners, a.material, a.origin) < std::tie(b.corners, b.material, b.origin);
  });
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    if (places[i].corners == places[i - 1].corners && places[i].material != places[i - 1].material)
      unrepaired.push_back({places[i].origin, "the same corners as another cell, of another material; both kept"});
  }
}
// Pieces of triangles stand at the end: back to where these stood, as of faces in one plane the later lies on top.
void sortByOrigin(TriangleMesh& mesh)
{
  if (std::is_sorted(mesh.origin.begin(), mesh.origin.end()))
    return;
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return mesh.origin[a] < mesh.origin[b]; });
  TriangleMesh sorted;
  sorted.points = std::move(mesh.points);
  for (const std::size_t t : order)
  {
    sorted.triangles.push_back(mesh.triangles[t]);
    sorted.origin.push_back(mesh.origin[t]);
    sorted.material.push_back(mesh.material[t]);
  }
  mesh = std::move(sorted);
}
}  // namespace

EdgeCounts countEdges(const TriangleMesh& mesh)
{
  EdgeCounts counts;
  const std::vector<Side> sides = sortedSides(mesh);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    counts.border += last - first == 1;
    counts.nonManifold += last - first > 2;
  });
  return counts;
}

RepairReport repair(TriangleMesh& mesh, const RepairSettings& settings, const Progress& progress)
{
  check(mesh);
  RepairReport result;
  result.pointsBefore = mesh.points.size();
  result.trianglesBefore = mesh.triangles.size();
  result.areaBefore = area(mesh);
  result.boundsBefore = bounds(mesh);
  result.borderBefore = countEdges(mesh).border;
  report(progress, 0.05);

  result.pointsUnused = dropUnusedPoints(mesh);
  const Tolerances tolerances(mesh, settings.tolerance);
  result.tolerance = tolerances.largest();
  const Merged merged = mergePoints(mesh, tolerances);
  result.pointsMerged = merged.points;
  result.pointsMoved = merged.moved;
  const double merging = area(mesh);
  result.degenerate = dropDegenerate(mesh, tolerances);
  if (mesh.triangles.empty())
    throw std::invalid_argument("every triangle is degenerate (lower than the tolerance of " +
                                std::to_string(result.tolerance) + " m); expected at least one that is not");
  const double sound = area(mesh);
  result.degenerateArea = merging - sound;
  const Duplicates duplicates = dropDuplicates(mesh, settings.sided);
  result.duplicate = duplicates.dropped;
  result.duplicateArea = sound - area(mesh);
  if (duplicates.kept > 0)
    nameDuplicates(mesh, result.unrepaired);
  report(progress, 0.25);

  result.splitTriangles = splitBorders(mesh, tolerances);
  result.nonManifoldBefore = countEdges(mesh).nonManifold;
  report(progress, 0.4);

  std::vector<std::uint8_t> turned;
  result.pointsSplit = orient(mesh, turned);
  report(progress, 0.85);
  chooseSides(mesh, settings, turned, result);
  dropUnusedPoints(mesh);
  sortByOrigin(mesh);

  const EdgeCounts edges = countEdges(mesh);
  result.borderAfter = edges.border;
  result.nonManifoldAfter = edges.nonManifold;
  result.pointsAfter = mesh.points.size();
  result.trianglesAfter = mesh.triangles.size();
  result.areaAfter = area(mesh);
  result.boundsAfter = bounds(mesh);
  report(progress, 1.0);
  return result;
}
}  // namespace kalos::meshing
