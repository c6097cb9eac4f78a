// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "mesh/Tolerances.h"

namespace kalos::meshing
{
void report(const Progress& progress, double share)
{
  if (progress && !progress(share))
    throw Stopped();
}

void check(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty())
    throw std::invalid_argument("the mesh has no triangles; expected at least one");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const std::uint32_t corner : mesh.triangles[t])
    {
      if (corner >= mesh.points.size())
        throw std::invalid_argument("cell " + std::to_string(mesh.origin[t]) + " uses point " + std::to_string(corner) +
                                    " of " + std::to_string(mesh.points.size()) + "; expected points that exist");
      const Point& p = mesh.points[corner];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        throw std::invalid_argument("point " + std::to_string(corner) + " of cell " + std::to_string(mesh.origin[t]) +
                                    " is NaN or infinite; expected finite coordinates");
    }
  }
}

Point doubledArea(const TriangleMesh& mesh, const Triangle& triangle)
{
  const Point& a = mesh.points[triangle[0]];
  return cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a);
}

double area(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const Triangle& triangle : mesh.triangles)
    sum += 0.5 * norm(doubledArea(mesh, triangle));
  return sum;
}

Bounds bounds(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty())
    return {};
  constexpr double far = std::numeric_limits<double>::max();
  Bounds box{{far, far, far}, {-far, -far, -far}};
  for (const Triangle& triangle : mesh.triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        box.low[axis] = std::min(box.low[axis], mesh.points[corner][axis]);
        box.high[axis] = std::max(box.high[axis], mesh.points[corner][axis]);
      }
    }
  }
  return box;
}

Merged mergePoints(TriangleMesh& mesh, const Tolerances& tolerances)
{
  // Sweep along a direction that buildings are rarely aligned with, and compare each point with the latest
  // representatives.
  const Point direction = unit({0.6180339887, 0.7548776662, 0.5698402910});
  const std::size_t n = mesh.points.size();
  std::vector<double> along(n);
  for (std::size_t i = 0; i < n; ++i)
    along[i] = dot(direction, mesh.points[i]);
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return along[a] != along[b] ? along[a] < along[b] : a < b; });
  std::vector<std::uint32_t> representative(n), passed;
  std::size_t first = 0;
  Merged merged;
  for (const std::uint32_t i : order)
  {
    while (first < passed.size() && along[i] - along[passed[first]] > tolerances.largest())
      ++first;
    representative[i] = i;
    for (std::size_t k = first; k < passed.size() && representative[i] == i; ++k)
    {
      if (norm(mesh.points[i] - mesh.points[passed[k]]) <= tolerances.of(i, passed[k]))
        representative[i] = passed[k];
    }
    if (representative[i] == i)
      passed.push_back(i);
    else
    {
      ++merged.points;
      merged.moved += mesh.points[i] != mesh.points[representative[i]];
    }
  }
  for (Triangle& triangle : mesh.triangles)
  {
    for (std::uint32_t& corner : triangle)
      corner = representative[corner];
  }
  return merged;
}

std::size_t dropUnusedPoints(TriangleMesh& mesh)
{
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.points.size(), unused);
  for (const Triangle& triangle : mesh.triangles)
  {
    for (const std::uint32_t corner : triangle)
      number[corner] = 0;
  }
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (number[i] == unused)
      continue;
    mesh.points[next] = mesh.points[i];
    number[i] = next++;
  }
  const std::size_t dropped = mesh.points.size() - next;
  mesh.points.resize(next);
  for (Triangle& triangle : mesh.triangles)
  {
    for (std::uint32_t& corner : triangle)
      corner = number[corner];
  }
  return dropped;
}

void keepMarked(TriangleMesh& mesh, const std::vector<std::uint8_t>& marks)
{
  std::size_t next = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!marks[t])
      continue;
    mesh.triangles[next] = mesh.triangles[t];
    mesh.origin[next] = mesh.origin[t];
    mesh.material[next] = mesh.material[t];
    ++next;
  }
  mesh.triangles.resize(next);
  mesh.origin.resize(next);
  mesh.material.resize(next);
}

std::size_t dropDegenerate(TriangleMesh& mesh, const Tolerances& tolerances)
{
  std::vector<std::uint8_t> marks(mesh.triangles.size());
  for (std::size_t t = 0; t < marks.size(); ++t)
  {
    const Triangle& triangle = mesh.triangles[t];
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, norm(mesh.points[triangle[k]] - mesh.points[triangle[(k + 1) % 3]]));
    marks[t] = norm(doubledArea(mesh, triangle)) > tolerances.of(triangle) * longest;
  }
  const std::size_t before = mesh.triangles.size();
  keepMarked(mesh, marks);
  return before - mesh.triangles.size();
}

Duplicates dropDuplicates(TriangleMesh& mesh, const std::vector<std::uint8_t>& sided)
{
  const std::size_t n = mesh.triangles.size();
  std::vector<Triangle> sorted = mesh.triangles;
  std::vector<std::uint8_t> turned(n, 0);
  for (std::size_t t = 0; t < n; ++t)
  {
    std::sort(sorted[t].begin(), sorted[t].end());
    const Triangle& c = mesh.triangles[t];
    if (mesh.origin[t] < sided.size() && sided[mesh.origin[t]])
      turned[t] = (c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0]) == 1;
  }
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (sorted[a] != sorted[b])
      return sorted[a] < sorted[b];
    if (mesh.material[a] != mesh.material[b])
      return mesh.material[a] < mesh.material[b];
    return turned[a] != turned[b] ? turned[a] < turned[b] : a < b;
  });
  std::vector<std::uint8_t> marks(n, 1);
  Duplicates duplicates;
  for (std::size_t i = 1; i < n; ++i)
  {
    if (sorted[order[i]] != sorted[order[i - 1]])
      continue;
    const bool other = mesh.material[order[i]] != mesh.material[order[i - 1]];
    marks[order[i]] = other || turned[order[i]] != turned[order[i - 1]];
    duplicates.kept += other;
    duplicates.dropped += !marks[order[i]];
  }
  keepMarked(mesh, marks);
  return duplicates;
}
}  // namespace kalos::meshing
