// SPDX-License-Identifier: BSD-3-Clause
#include "singular/Curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/Tolerances.h"

namespace kalos::meshing
{
namespace
{
constexpr double sameAngle = 1e-3;       // radians
constexpr double straight = 1.0 - 1e-6;  // cosine: 0.08 degrees
constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

bool alike(const EdgeProperties& a, const EdgeProperties& b)
{
  const auto same = [](double x, double y) { return x == y || std::abs(x - y) < sameAngle; };
  return a.kind == b.kind && same(a.front, b.front) && same(a.back, b.back);
}

/// Segment s at one of its ends, 0 or 1.
struct End
{
  std::uint32_t point, segment, end;
};

/// The segments beyond the two ends of one.
using Links = std::array<std::uint32_t, 2>;

/// For each end of a segment the segment that continues it straight on.
std::vector<Links> linkEnds(const std::vector<Segment>& segments, const TriangleMesh& ends)
{
  std::vector<End> order;
  std::vector<Point> direction;
  for (std::uint32_t s = 0; s < segments.size(); ++s)
  {
    order.push_back({ends.triangles[s][0], s, 0});
    order.push_back({ends.triangles[s][1], s, 1});
    direction.push_back(unit(segments[s].end - segments[s].start));
  }
  std::sort(order.begin(), order.end(), [](const End& a, const End& b) {
    return a.point != b.point ? a.point < b.point : a.segment != b.segment ? a.segment < b.segment : a.end < b.end;
  });
  std::vector<Links> next(segments.size(), Links{nobody, nobody});
  for (std::size_t first = 0, last = 0; first < order.size(); first = last)
  {
    while (last < order.size() && order[last].point == order[first].point)
      ++last;
    for (std::size_t i = first; i < last; ++i)
    {
      for (std::size_t j = i + 1; j < last && next[order[i].segment][order[i].end] == nobody; ++j)
      {
        const End &a = order[i], &b = order[j];
        const double sign = a.end == b.end ? -1.0 : 1.0;
        if (a.segment != b.segment && next[b.segment][b.end] == nobody &&
            sign * dot(direction[a.segment], direction[b.segment]) > straight &&
            alike(segments[a.segment].edge, segments[b.segment].edge))
        {
          next[a.segment][a.end] = b.segment;
          next[b.segment][b.end] = a.segment;
        }
      }
    }
  }
  return next;
}
}  // namespace

void joinSegments(const std::vector<Segment>& segments, double distance, Curves& result)
{
  // Number the ends.
  TriangleMesh ends;  // its merging of points serves here too
  for (const Segment& s : segments)
  {
    const auto first = static_cast<std::uint32_t>(ends.points.size());
    ends.points.push_back(s.start);
    ends.points.push_back(s.end);
    ends.triangles.push_back({first, first + 1, first + 1});
  }
  mergePoints(ends, Tolerances(ends, distance));
  dropUnusedPoints(ends);

  const std::vector<Links> next = linkEnds(segments, ends);

  // Walk each chain from one of its ends.
  result.points = std::move(ends.points);
  std::vector<std::uint8_t> done(segments.size(), 0);
  for (std::uint32_t s = 0; s < segments.size(); ++s)
  {
    if (done[s] || (next[s][0] != nobody && next[s][1] != nobody))
      continue;
    Curve curve{result.indices.size(), 0, segments[s].edge};
    std::uint32_t from = next[s][0] == nobody ? 0 : 1;  // the end at which the walk enters
    std::uint32_t at = s;
    result.indices.push_back(ends.triangles[at][from]);
    while (true)
    {
      done[at] = 1;
      const std::uint32_t leaving = ends.triangles[at][1 - from];
      result.indices.push_back(leaving);
      const std::uint32_t following = next[at][1 - from];
      if (following == nobody)
        break;
      from = next[following][0] == at && ends.triangles[following][0] == leaving ? 0 : 1;
      at = following;
    }
    curve.count = result.indices.size() - curve.first;
    result.curves.push_back(curve);
  }
}
}  // namespace kalos::meshing
