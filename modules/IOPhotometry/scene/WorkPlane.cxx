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
  double Area = 0.0;
  double Height = 0.0;  ///< of its highest point
  double Low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double High[2] = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

/** Calls `visit(points, number of points, vector area)` for every polygon. */
template <typename Visit>
void ForEachPolygon(const std::vector<Surface>& surfaces, Visit visit)
{
  for (const Surface& surface : surfaces)
  {
    const Mesh& mesh = surface.Polygons;
    for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
    {
      std::vector<Vector3> corners;
      for (std::int64_t i = mesh.Begin(p); i < mesh.Ends[p]; ++i)
      {
        corners.push_back(mesh.Points[mesh.Corners[i]]);
      }
      visit(corners, mesh.Area(p));
    }
  }
}

/** The level of the largest area among horizontal faces up to a height. */
std::optional<Patch> LargestLevel(const std::vector<Surface>& surfaces, double below, bool upOnly)
{
  std::map<long long, Patch> levels;
  ForEachPolygon(surfaces, [&](const std::vector<Vector3>& corners, const Vector3& area) {
    const double up = area[2] / norm(area);
    if (!((upOnly ? up : std::abs(up)) > Level) || corners[0][2] > below)
    {
      return;
    }
    Patch& patch = levels[std::llround(corners[0][2] / LevelThickness)];
    patch.Height = patch.Area > 0.0 ? std::max(patch.Height, corners[0][2]) : corners[0][2];
    patch.Area += norm(area);
    for (const Vector3& corner : corners)
    {
      for (int i = 0; i < 2; ++i)
      {
        patch.Low[i] = std::min(patch.Low[i], corner[i]);
        patch.High[i] = std::max(patch.High[i], corner[i]);
      }
    }
  });
  const auto largest = std::max_element(levels.begin(), levels.end(),
                                        [](const auto& a, const auto& b) { return a.second.Area < b.second.Area; });
  return largest == levels.end() ? std::nullopt : std::optional<Patch>(largest->second);
}
}  // namespace

std::optional<WorkPlane> FindWorkPlane(const std::vector<Surface>& surfaces, double top)
{
  double bottom = top;
  ForEachPolygon(surfaces, [&](const std::vector<Vector3>& corners, const Vector3&) {
    for (const Vector3& corner : corners)
    {
      bottom = std::min(bottom, corner[2]);
      top = std::max(top, corner[2]);
    }
  });
  const double third = bottom + (top - bottom) / 3.0;
  std::optional<Patch> floor = LargestLevel(surfaces, third, true);
  floor = floor ? floor : LargestLevel(surfaces, third, false);
  if (!floor || !(floor->Height + WorkHeight < top))
  {
    return {};
  }
  return WorkPlane{
      {floor->Low[0], floor->Low[1]}, {floor->High[0], floor->High[1]}, floor->Height + WorkHeight, floor->Height};
}
}  // namespace kalos::scene
