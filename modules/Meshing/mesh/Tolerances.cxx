// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/Tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kalos::meshing
{
namespace
{
constexpr double shareOfDiagonal = 1e-6;
constexpr double shareOfEdge = 1e-4;

/** Relative rounding error of the coordinates: that of float32 if all of them fit into it, else that of double. */
double roundingOf(const TriangleMesh& mesh)
{
  const auto isSingle = [](double c) { return static_cast<double>(static_cast<float>(c)) == c; };
  const bool single = std::all_of(mesh.points.begin(), mesh.points.end(),
                                  [&](const Point& p) { return std::all_of(p.begin(), p.end(), isSingle); });
  return 3.0 * (single ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
}

/** For each point its shortest edge of at least `least`, or else its longest. */
std::vector<double> edgeLengths(const TriangleMesh& mesh, double least)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> shortest(mesh.points.size(), none), longest(mesh.points.size(), 0.0);
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double length = norm(mesh.points[b] - mesh.points[a]);
      for (const std::uint32_t point : {a, b})
      {
        shortest[point] = length >= least ? std::min(shortest[point], length) : shortest[point];
        longest[point] = std::max(longest[point], length);
      }
    }
  }
  for (std::size_t i = 0; i < shortest.size(); ++i)
    shortest[i] = shortest[i] < none ? shortest[i] : longest[i];
  return shortest;
}
}  // namespace

Tolerances::Tolerances(const TriangleMesh& mesh, double wanted) : Uniform(wanted), Largest(wanted)
{
  if (wanted > 0.0)
    return;
  const double most = shareOfDiagonal * bounds(mesh).diagonal(), rounding = roundingOf(mesh);
  Local = edgeLengths(mesh, most);
  for (std::size_t i = 0; i < Local.size(); ++i)
  {
    const Point& p = mesh.points[i];
    const double size = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    Local[i] = std::max(rounding * size, std::min(most, shareOfEdge * Local[i]));
    Largest = std::max(Largest, Local[i]);
  }
}
}  // namespace kalos::meshing
