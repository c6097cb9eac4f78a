// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/CandelaBound.h"

namespace kalos
{
namespace
{
constexpr double degree = pi / 180, margin = 0.02;  // of a bin, on either side
constexpr double above = 1 + 1e-6;                  // for rounding to single precision

// Polar angle where a row begins, degrees.
double angleAt(double row)
{
  return 2 * std::asin(std::clamp(row / CandelaBound::rows, 0.0, 1.0)) / degree;
}

// Plane where a column begins, degrees, ascending through quadrants from -90.
double planeAt(double column)
{
  const double u = 4 * column / CandelaBound::columns, quadrant = std::floor(u), f = u - quadrant;
  return 90 * quadrant + std::atan2(f - 1, f) / degree;
}

// Largest of a piecewise linear function within [from, to]; 0 outside its support.
double largestWithin(const std::vector<double>& x, const double* y, double from, double to)
{
  from = std::max(from, x.front());
  to = std::min(to, x.back());
  if (!(from <= to))
    return 0;
  auto at = [&](double t) {
    const std::size_t next =
        std::clamp<std::size_t>(std::upper_bound(x.begin(), x.end(), t) - x.begin(), 1, x.size() - 1);
    const double share = (t - x[next - 1]) / (x[next] - x[next - 1]);
    return (1 - share) * y[next - 1] + share * y[next];
  };
  double largest = std::max(at(from), at(to));
  for (std::size_t k = std::lower_bound(x.begin(), x.end(), from) - x.begin(); k < x.size() && x[k] <= to; ++k)
    largest = std::max(largest, y[k]);
  return largest;
}
}  // namespace

CandelaBound::CandelaBound(const CandelaTable& table) : Largest(rows * columns)
{
  const std::vector<double>& planes = table.planes();
  const std::size_t angles = table.angles().size();
  std::vector<double> ofPlane(planes.size());
  for (int row = 0; row < rows; ++row)
  {
    // Between planes the largest values are joined linearly: no less than what lies between.
    for (std::size_t p = 0; p < planes.size(); ++p)
      ofPlane[p] =
          largestWithin(table.angles(), &table.candela()[p * angles], angleAt(row - margin), angleAt(row + 1 + margin));
    for (int column = 0; column < columns; ++column)
    {
      double largest = 0;
      // Planes may be counted from anywhere.
      const double from = planeAt(column - margin), to = planeAt(column + 1 + margin);
      const double first = std::floor((planes.front() - to) / 360), last = std::ceil((planes.back() - from) / 360);
      for (double turns = first; turns <= last; ++turns)
        largest = std::max(largest, largestWithin(planes, ofPlane.data(), from + 360 * turns, to + 360 * turns));
      this->Largest[row * columns + column] = static_cast<float>(above * largest);
    }
  }
}
}  // namespace kalos
