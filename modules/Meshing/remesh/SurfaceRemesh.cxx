// SPDX-License-Identifier: BSD-3-Clause
#include "remesh/SurfaceRemesh.h"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

#include "mesh/NearestTriangle.h"
#include "remesh/Remesher.h"
#include "repair/SurfaceRepair.h"
#include "singular/EdgeDistance.h"

namespace kalos::meshing
{
namespace
{
/// Edge lengths that the input's cells ask for, looked up by position.
class CellWishes
{
public:
  CellWishes(const TriangleMesh& mesh, const std::vector<double>& wanted)
  {
    if (wanted.empty())
      return;
    for (const std::uint32_t origin : mesh.origin)
      Wishes.push_back(origin < wanted.size() ? wanted[origin] : Least);
    Least = *std::min_element(Wishes.begin(), Wishes.end());
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    Tree = std::make_unique<NearestTriangle>(mesh, all);
  }
  double least() const { return Least; }
  double at(const Point& p) const { return Tree ? Wishes[Tree->to(p)] : std::numeric_limits<double>::infinity(); }

private:
  std::vector<double> Wishes;
  double Least = std::numeric_limits<double>::infinity();
  std::unique_ptr<NearestTriangle> Tree;
};

double lengthOf(const Curves& curves)
{
  double sum = 0.0;
  for (const Curve& c : curves.curves)
  {
    for (std::size_t i = c.first; i + 1 < c.first + c.count; ++i)
      sum += norm(curves.points[curves.indices[i + 1]] - curves.points[curves.indices[i]]);
  }
  return sum;
}

/// Bytes of memory of this machine; infinite where it cannot be told.
double physicalMemory()
{
#ifdef _SC_PHYS_PAGES
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
#else
  return std::numeric_limits<double>::infinity();
#endif
}

void refuseTooMany(double expected, std::size_t maximum)
{
  constexpr double bytesPerTriangle = 500;  // 410 measured
  const double held = physicalMemory() / bytesPerTriangle;
  const auto most = static_cast<double>(maximum);
  if (expected <= std::min(most, held))
    return;
  std::ostringstream text;
  text << std::setprecision(3) << "the edge length needs about " << expected << " triangles; expected one that needs "
       << (held < most ? "no more than the memory of this machine holds, " : "at most ") << std::min(most, held);
  throw std::invalid_argument(text.str());
}

void checkSettings(const TriangleMesh& mesh, const RemeshSettings& settings)
{
  const auto length = [](double l) { return l > 0.0 && std::isfinite(l); };
  if (!length(settings.edgeLength))
    throw std::invalid_argument("the edge length is not allowed; expected metres above 0");
  if (settings.smallest != 0.0 && (!length(settings.smallest) || !length(settings.grading)))
    throw std::invalid_argument("the smallest edge length or the grading is not allowed; expected numbers above 0");
  for (std::size_t t = 0; t < mesh.origin.size(); ++t)
  {
    if (mesh.origin[t] < settings.wanted.size() && !(settings.wanted[mesh.origin[t]] > 0.0))
      throw std::invalid_argument("the edge length that cell " + std::to_string(mesh.origin[t]) +
                                  " wants is not allowed; expected metres above 0");
  }
}
}  // namespace

RemeshReport remesh(TriangleMesh& mesh, const RemeshSettings& settings, const Progress& progress)
{
  check(mesh);
  checkSettings(mesh, settings);
  RemeshReport result;
  result.trianglesBefore = mesh.triangles.size();
  result.areaBefore = area(mesh);
  const bool graded = settings.smallest > 0.0 && settings.smallest < settings.edgeLength;
  const Curves curves = graded ? findSingularEdges(mesh, {}) : Curves();
  const double expected = expectedTriangles(mesh, settings, lengthOf(curves));
  refuseTooMany(expected, settings.maximumTriangles);
  report(progress, 0.05);

  std::vector<std::uint8_t> turned;
  orient(mesh, turned);
  Remesher remesher(mesh, std::move(turned), progress);
  result.patches = remesher.findPatches(settings.feature);

  // The wanted length anywhere, and the length of the finest level.
  const EdgeDistance edges(curves);
  const CellWishes wishes(mesh, settings.wanted);
  const auto wanted = [&](const Point& p) {
    const double byDistance = settings.smallest + settings.grading * edges.nearest(p).distance;
    return std::min(graded ? byDistance : settings.edgeLength, wishes.at(p));
  };
  const double finest = std::min(graded ? settings.smallest : settings.edgeLength, wishes.least());
  int levels = 0;
  for (double length = settings.edgeLength; length > 1.5 * finest; length *= 0.5)
    ++levels;

  const double steps = settings.iterations * (1.0 + levels);
  double step = 0.0;
  const auto next = [&] { remesher.setShare(0.05 + 0.9 * ++step / steps); };
  for (int i = 0; i < settings.iterations; ++i)
  {
    remesher.iterate(settings.edgeLength);
    next();
  }
  double length = settings.edgeLength;
  for (int level = 0; level < levels; ++level)
  {
    length *= 0.5;
    for (int i = 0; i < settings.iterations; ++i)
    {
      remesher.iterateWhere(wanted, 1.5 * length, length);
      next();
    }
  }

  mesh = remesher.result();
  result.trianglesAfter = mesh.triangles.size();
  result.pointsAfter = mesh.points.size();
  result.areaAfter = area(mesh);
  measureQuality(mesh, settings.edgeLength, result);
  report(progress, 1.0);
  return result;
}
}  // namespace kalos::meshing
