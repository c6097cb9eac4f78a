// SPDX-License-Identifier: BSD-3-Clause
// Also known as: importance sampling of an environment map; piecewise-constant distribution.
#ifndef kalos_sky_DirectionTable_h
#define kalos_sky_DirectionTable_h

#include <functional>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
/// Directions drawn about in proportion to a function on the sphere: constant in cells of equal steps of z and azimuth.
/// z = 0 is a border between cells.
class DirectionTable
{
public:
  /// `value` is >= 0. Cells where it is positive at some of the probed points are drawn with a positive density.
  explicit DirectionTable(const std::function<double(const Vec3&)>& value);

  bool isEmpty() const { return !(this->Total > 0); }
  /// About the integral of the function over the sphere.
  double integral() const { return this->Total; }

  /// For u1, u2 in [0,1); only when it is not empty.
  Vec3 sample(double u1, double u2) const;

  /// Density of sample(), per sr.
  double density(const Vec3& direction) const;

private:
  static constexpr int rows = 128, columns = 128, probes = 3;

  std::vector<double> Rows;   // integral up to and including row i
  std::vector<double> Cells;  // in each row, integral up to and including column j
  double Total = 0;
};
}  // namespace kalos

#endif
