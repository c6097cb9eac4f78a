// SPDX-License-Identifier: BSD-3-Clause
// Covers points of a plane with few rectangles of little area.
#ifndef kalos_scene_RectangleCover_h
#define kalos_scene_RectangleCover_h

#include <array>
#include <vector>

namespace kalos
{
struct CoverRectangle
{
  double low[2], high[2];
  std::size_t points;
  double area() const { return (this->high[0] - this->low[0]) * (this->high[1] - this->low[1]); }
};

/// A rectangle about the points is divided in two while that saves a good share of its area. Each is then widened by
/// what its points may have missed at the border of a uniformly lit opening.
std::vector<CoverRectangle> coverPoints(std::vector<std::array<double, 2>> points);
}  // namespace kalos

#endif
