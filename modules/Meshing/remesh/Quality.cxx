// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/SortedSides.h"
#include "remesh/SurfaceRemesh.h"

namespace kalos::meshing
{
namespace
{
constexpr double pi = 3.14159265358979323846;
const double equilateral = std::sqrt(3.0) / 4.0;  // area over squared side
}  // namespace

double expectedTriangles(const TriangleMesh& mesh, const RemeshSettings& settings, double singularLength)
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    double length = settings.edgeLength;
    if (mesh.origin[t] < settings.wanted.size())
      length = std::min(length, settings.wanted[mesh.origin[t]]);
    sum += 0.5 * norm(doubledArea(mesh, mesh.triangles[t])) / (equilateral * length * length);
  }
  // On both sides of an edge, the integral of 1/(smallest + grading d)² over the distance d.
  if (settings.smallest > 0.0 && settings.smallest < settings.edgeLength)
    sum += 2.0 * singularLength / (equilateral * settings.grading * settings.smallest);
  return sum;
}

void measureQuality(const TriangleMesh& mesh, double wanted, RemeshReport& report)
{
  report.minimumAngle = pi;
  std::size_t small = 0;
  for (const Triangle& t : mesh.triangles)
  {
    double least = pi;
    for (int k = 0; k < 3; ++k)
    {
      const Point a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const Point b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      least = std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
    report.minimumAngle = std::min(report.minimumAngle, least);
    small += least < pi / 9;
  }
  report.smallAngles = mesh.triangles.empty() ? 0.0 : static_cast<double>(small) / mesh.triangles.size();

  report.shortest = std::numeric_limits<double>::max();
  std::size_t edges = 0;
  double sum = 0.0;
  const std::vector<Side> sides = sortedSides(mesh);
  forEachEdge(sides, [&](std::size_t first, std::size_t) {
    const double length = norm(mesh.points[sides[first].high] - mesh.points[sides[first].low]);
    report.shortest = std::min(report.shortest, length);
    report.longest = std::max(report.longest, length);
    sum += length;
    ++edges;
    ++report.histogram[static_cast<std::size_t>(std::clamp(4.0 * length / wanted, 0.0, 7.0))];
  });
  report.mean = edges > 0 ? sum / static_cast<double>(edges) : 0.0;
}
}  // namespace kalos::meshing
