// SPDX-License-Identifier: BSD-3-Clause
// An upper bound of a candela table that is looked up without an angle: what luminaires are chosen by.
#ifndef kalos_photometry_CandelaBound_h
#define kalos_photometry_CandelaBound_h

#include "photometry/CandelaTable.h"

namespace kalos
{
/// The largest intensity in each of 32 x 16 bins of directions, a little wider than they are so that single precision
/// may miss one by rounding. With components p along the table's pole, z towards plane 0 and q towards plane 90, of a
/// direction of length d, a row is 32 sqrt((1 - p/d)/2), the sine of half the polar angle, and a column
/// 4 (t + 1) where z >= 0, else 4 (3 - t), with t = q / (|z| + |q|): it grows with the plane, as an angle does.
class CandelaBound
{
public:
  static constexpr int rows = 32, columns = 16;

  explicit CandelaBound(const CandelaTable& table);

  /// cd, rows times columns values.
  const std::vector<float>& candela() const { return this->Largest; }

private:
  std::vector<float> Largest;
};
}  // namespace kalos

#endif
