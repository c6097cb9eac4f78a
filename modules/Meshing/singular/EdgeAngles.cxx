// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeAngles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kalos::meshing
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double none = std::numeric_limits<double>::infinity();

/// A sheet by its angle about the axis; ahead and behind say on which sides it shows its front, to either after
/// merging.
struct Spoke
{
  double angle;
  bool frontAhead, frontBehind;
  bool backAhead, backBehind;
};

std::vector<Spoke> spokesOf(const Point& axis, const std::vector<Sheet>& sheets, double flat)
{
  const Point x = sheets.front().direction;
  const Point y = cross(axis, x);
  std::vector<Spoke> spokes;
  for (const Sheet& sheet : sheets)
  {
    double angle = std::atan2(dot(sheet.direction, y), dot(sheet.direction, x));
    if (angle < -0.5 * flat)
      angle += 2.0 * pi;
    const bool ahead = dot(sheet.normal, cross(axis, sheet.direction)) > 0.0;
    spokes.push_back({angle, ahead, !ahead, !ahead, ahead});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });

  // Close the gaps between sheets that lie on each other.
  std::vector<Spoke> merged;
  for (const Spoke& s : spokes)
  {
    if (merged.empty() || s.angle - merged.back().angle >= flat)
    {
      merged.push_back(s);
      continue;
    }
    Spoke& m = merged.back();
    m.frontAhead |= s.frontAhead;
    m.frontBehind |= s.frontBehind;
    m.backAhead |= s.backAhead;
    m.backBehind |= s.backBehind;
  }
  if (merged.size() > 1 && merged.front().angle + 2.0 * pi - merged.back().angle < flat)
  {
    Spoke& m = merged.front();
    const Spoke& s = merged.back();
    m.frontAhead |= s.frontAhead;
    m.frontBehind |= s.frontBehind;
    m.backAhead |= s.backAhead;
    m.backBehind |= s.backBehind;
    merged.pop_back();
  }
  return merged;
}
}  // namespace

EdgeAngles measureAngles(const Point& axis, const std::vector<Sheet>& sheets, double flat)
{
  const std::vector<Spoke> spokes = spokesOf(axis, sheets, flat);
  EdgeAngles angles{none, none, false};
  // A single or doubled sheet faces nothing else: a full turn, as at the rim of a thin panel.
  if (spokes.size() < 2)
    return {2.0 * pi, 0.0, false};
  double smallest = none;
  for (std::size_t i = 0; i < spokes.size(); ++i)
  {
    const Spoke& a = spokes[i];
    const Spoke& b = spokes[(i + 1) % spokes.size()];
    const double wedge = b.angle - a.angle + (i + 1 == spokes.size() ? 2.0 * pi : 0.0);
    if (a.frontAhead && b.frontBehind)
      angles.front = std::min(angles.front, wedge);
    if (a.backAhead && b.backBehind)
      angles.back = std::min(angles.back, wedge);
    smallest = std::min(smallest, wedge);
  }
  if (angles.front == none && angles.back == none)
    return {smallest, 2.0 * pi - smallest, true};
  return angles;
}

double severity(double angle)
{
  if (!(angle < pi) || angle <= 0.0)
    return 0.0;
  const double cotangent = 1.0 / std::tan(0.5 * angle);
  return 0.25 * cotangent * cotangent;
}
}  // namespace kalos::meshing
