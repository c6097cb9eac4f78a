// SPDX-License-Identifier: BSD-3-Clause
#include "WorkPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace kalos::scene
{
namespace
{
constexpr double LevelThickness = 0.01;  // m
constexpr double Level = 0.999;          // cosine to the vertical from which on a face is horizontal

struct Patch
{
  double area = 0.0;
  double height = 0.0;  ///< of its highest point
  double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double high[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

/** Calls `visit(points, number of points, vector area)` for every polygon. */
template <typename Visit>
void forEachPolygon(const std::vector<Surface>& surfaces, Visit visit)
{
  for (const Surface& surface : surfaces)
  {
    const Mesh& mesh = surface.polygons;
    for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
    {
      std::vector<Vector3> corners;
      for (std::int64_t i = mesh.begin(p); i < mesh.ends[p]; ++i)
      {
        corners.push_back(mesh.points[mesh.corners[i]]);
      }
      visit(corners, mesh.area(p));
    }
  }
}

/** The level of the largest area among horizontal faces up to a height. */
std::optional<Patch> largestLevel(const std::vector<Surface>& surfaces, double below, bool upOnly)
{
  std::map<long long, Patch> levels;
  forEachPolygon(surfaces, [&](const std::vector<Vector3>& corners, const Vector3& area) {
    const double up = area[2] / norm(area);
    if (!((upOnly ? up : std::abs(up)) > Level) || corners[0][2] > below)
    {
      return;
    }
    Patch& patch = levels[std::llround(corners[0][2] / LevelThickness)];
    patch.height = patch.area > 0.0 ? std::max(patch.height, corners[0][2]) : corners[0][2];
    patch.area += norm(area);
    for (const Vector3& corner : corners)
    {
      for (int i = 0; i < 2; ++i)
      {
        patch.low[i] = std::min(patch.low[i], corner[i]);
        patch.high[i] = std::max(patch.high[i], corner[i]);
      }
    }
  });
  const auto largest = std::max_element(levels.begin(), levels.end(),
                                        [](const auto& a, const auto& b) { return a.second.area < b.second.area; });
  return largest == levels.end() ? std::nullopt : std::optional<Patch>(largest->second);
}
}  // namespace

std::optional<WorkPlane> findWorkPlane(const std::vector<Surface>& surfaces, double top)
{
  double bottom = top;
  forEachPolygon(surfaces, [&](const std::vector<Vector3>& corners, const Vector3&) {
    for (const Vector3& corner : corners)
    {
      bottom = std::min(bottom, corner[2]);
      top = std::max(top, corner[2]);
    }
  });
  const double third = bottom + (top - bottom) / 3.0;
  std::optional<Patch> floor = largestLevel(surfaces, third, true);
  floor = floor ? floor : largestLevel(surfaces, third, false);
  if (!floor || !(floor->height + WorkHeight < top))
  {
    return {};
  }
  return WorkPlane{
      {floor->low[0], floor->low[1]}, {floor->high[0], floor->high[1]}, floor->height + WorkHeight, floor->height};
}
}  // namespace kalos::scene
