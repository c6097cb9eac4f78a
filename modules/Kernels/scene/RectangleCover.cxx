// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RectangleCover.h"

#include <algorithm>

namespace kalos
{
namespace
{
constexpr double worthwhile = 0.8;  // area of the parts over that of the whole
constexpr std::size_t fewest = 8;   // points of a part
constexpr int deepest = 4;          // divisions of a whole
constexpr double border = 5;        // widths between neighbouring points that a border may lie beyond the outermost
constexpr double least = 2e-3;      // of the side

using Point = std::array<double, 2>;
using Iterator = std::vector<Point>::iterator;

CoverRectangle around(Iterator first, Iterator last)
{
  CoverRectangle r{{(*first)[0], (*first)[1]}, {(*first)[0], (*first)[1]}, static_cast<std::size_t>(last - first)};
  for (Iterator p = first; p != last; ++p)
    for (int k = 0; k < 2; ++k)
    {
      r.low[k] = std::min(r.low[k], (*p)[k]);
      r.high[k] = std::max(r.high[k], (*p)[k]);
    }
  return r;
}

// Areas of the rectangles about the first i points, i = 0 .. n, as they stand.
template <class Forward>
std::vector<double> growingAreas(Forward first, std::size_t n)
{
  std::vector<double> areas{0};
  CoverRectangle r{{(*first)[0], (*first)[1]}, {(*first)[0], (*first)[1]}, 0};
  for (std::size_t i = 0; i < n; ++i, ++first)
  {
    for (int k = 0; k < 2; ++k)
    {
      r.low[k] = std::min(r.low[k], (*first)[k]);
      r.high[k] = std::max(r.high[k], (*first)[k]);
    }
    areas.push_back(r.area());
  }
  return areas;
}

void cover(Iterator first, Iterator last, int depth, std::vector<CoverRectangle>& found)
{
  const CoverRectangle whole = around(first, last);
  const auto n = static_cast<std::size_t>(last - first);
  double best = worthwhile * whole.area();
  int axis = -1;
  std::size_t cut = 0;
  for (int k = 0; k < 2 && depth < deepest && n >= 2 * fewest; ++k)
  {
    std::sort(first, last, [k](const Point& a, const Point& b) { return a[k] < b[k]; });
    const std::vector<double> left = growingAreas(first, n);
    const std::vector<double> right = growingAreas(std::make_reverse_iterator(last), n);
    for (std::size_t i = fewest; i + fewest <= n; ++i)
      if (left[i] + right[n - i] < best)
      {
        best = left[i] + right[n - i];
        axis = k;
        cut = i;
      }
  }
  if (axis < 0)
  {
    found.push_back(whole);
    return;
  }
  std::sort(first, last, [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  const Iterator middle = first + static_cast<std::ptrdiff_t>(cut);
  cover(first, middle, depth + 1, found);
  cover(middle, last, depth + 1, found);
}
}  // namespace

std::vector<CoverRectangle> coverPoints(std::vector<Point> points)
{
  std::vector<CoverRectangle> found;
  if (points.empty())
    return found;
  std::sort(points.begin(), points.end());
  cover(points.begin(), points.end(), 0, found);
  for (CoverRectangle& r : found)
    for (int k = 0; k < 2; ++k)
    {
      const double wider = (r.high[k] - r.low[k]) * (border / static_cast<double>(r.points) + least);
      r.low[k] -= wider;
      r.high[k] += wider;
    }
  return found;
}
}  // namespace kalos
