// SPDX-License-Identifier: BSD-3-Clause
#include "singular/Contacts.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <numeric>

#include "mesh/Tolerances.h"

namespace kalos::meshing
{
namespace
{
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

template <std::size_t N>
Box boxAround(const std::array<Point, N>& corners, double margin, std::uint32_t index)
{
  double low[3], high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = high[axis] = corners[0][axis];
    for (const Point& p : corners)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
    low[axis] -= margin;
    high[axis] += margin;
  }
  return Box(low, high, index);
}

/// Disjoint sets of pieces.
class Groups
{
public:
  explicit Groups(std::size_t n) : Parent(n) { std::iota(Parent.begin(), Parent.end(), 0u); }
  std::uint32_t find(std::uint32_t i)
  {
    while (Parent[i] != i)
      i = Parent[i] = Parent[Parent[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { Parent[find(i)] = find(j); }

private:
  std::vector<std::uint32_t> Parent;
};

/// Whether two pieces lie on one line and overlap or touch: triangles that meet in less than `intersect` sees leave
/// gaps.
bool overlap(const Segment& a, const Segment& b, double distance)
{
  const Segment& longer = norm(a.end - a.start) >= norm(b.end - b.start) ? a : b;
  const Segment& shorter = &longer == &a ? b : a;
  const Point direction = unit(longer.end - longer.start);
  // A short piece at a corner is near the lines of both its sides.
  if (norm(cross(direction, unit(shorter.end - shorter.start))) > 1e-3)
    return false;
  double along[2];
  int i = 0;
  for (const Point& p : {shorter.start, shorter.end})
  {
    const Point offset = p - longer.start;
    along[i] = dot(offset, direction);
    if (norm(offset - along[i] * direction) > 4.0 * distance)
      return false;
    ++i;
  }
  const double length = norm(longer.end - longer.start);
  return std::min(std::max(along[0], along[1]), length) - std::max(std::min(along[0], along[1]), 0.0) > -4.0 * distance;
}

/// The pieces of one line, cut where one begins or ends; the severest of those that cover a part stands for it. Small
/// gaps are closed.
void joinGroup(const std::vector<Segment>& group, double distance, std::vector<Segment>& joined)
{
  const Segment& longest = *std::max_element(group.begin(), group.end(), [](const Segment& a, const Segment& b) {
    return norm(a.end - a.start) < norm(b.end - b.start);
  });
  const Point origin = longest.start, direction = unit(longest.end - longest.start);
  struct Span
  {
    double low, high;
    const Segment* piece;
  };
  std::vector<Span> spans;
  std::vector<double> cuts;
  for (const Segment& piece : group)
  {
    const double s = dot(piece.start - origin, direction), e = dot(piece.end - origin, direction);
    spans.push_back({std::min(s, e), std::max(s, e), &piece});
    cuts.push_back(s);
    cuts.push_back(e);
  }
  std::sort(cuts.begin(), cuts.end());
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  std::vector<const Span*> open;
  std::size_t next = 0;
  double from = cuts.front();
  for (const double to : cuts)
  {
    if (to - from <= 4.0 * distance)
      continue;
    const double middle = 0.5 * (from + to);
    while (next < spans.size() && spans[next].low < middle)
      open.push_back(&spans[next++]);
    open.erase(std::remove_if(open.begin(), open.end(), [=](const Span* s) { return s->high < middle; }), open.end());
    if (!open.empty())
    {
      const Span& severest = **std::max_element(open.begin(), open.end(), [](const Span* a, const Span* b) {
        return a->piece->edge.severity < b->piece->edge.severity;
      });
      joined.push_back({origin + from * direction, origin + to * direction, severest.piece->edge});
    }
    from = to;
  }
}
}  // namespace

std::vector<Segment> joinOverlaps(const std::vector<Segment>& pieces, double distance)
{
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    boxes.push_back(boxAround<2>({pieces[i].start, pieces[i].end}, 4.0 * distance, i));
  Groups groups(pieces.size());
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (groups.find(a.info()) != groups.find(b.info()) && overlap(pieces[a.info()], pieces[b.info()], distance))
      groups.join(a.info(), b.info());
  });

  std::vector<std::uint32_t> order(pieces.size()), root(pieces.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    root[i] = groups.find(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return root[a] < root[b]; });
  std::vector<Segment> joined, group;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    group.push_back(pieces[order[i]]);
    if (i + 1 == order.size() || root[order[i + 1]] != root[order[i]])
    {
      joinGroup(group, distance, joined);
      group.clear();
    }
  }
  return joined;
}

void appendContacts(const TriangleMesh& mesh, const Tolerances& tolerances, const EdgeSettings& settings,
                    std::vector<Segment>& pieces, const Progress& progress)
{
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    boxes.push_back(boxAround<3>({mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]}, 0.5 * tolerances.of(c), t));
  }

  std::vector<Segment> found;
  std::size_t pairs = 0;
  // A triangle of a usual mesh meets the boxes of some ten others.
  const double expected = 10.0 * static_cast<double>(mesh.triangles.size());
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    Segment piece;
    const Triangle &first = mesh.triangles[a.info()], &second = mesh.triangles[b.info()];
    const double distance = std::min(tolerances.of(first), tolerances.of(second));
    if (intersect(mesh, first, second, distance, settings, piece))
      found.push_back(piece);
    if (++pairs % 65536 == 0)
      report(progress, std::min(0.99, static_cast<double>(pairs) / expected));
  });
  const std::vector<Segment> joined = joinOverlaps(found, tolerances.largest());
  pieces.insert(pieces.end(), joined.begin(), joined.end());
}
}  // namespace kalos::meshing
