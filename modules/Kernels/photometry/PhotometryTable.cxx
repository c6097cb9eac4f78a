// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/PhotometryTable.h"

#include <map>

#include "photometry/PhotometryText.h"

namespace kalos
{
namespace
{
constexpr double sameAngle = 1e-6;  // degrees
}

void PhotometryRows::mirrorPlanes(double axis)
{
  std::vector<std::pair<double, std::vector<double>>> all;
  for (std::size_t p = 0; p < this->planes.size(); ++p)
  {
    all.emplace_back(this->planes[p], this->candela[p]);
    if (std::abs(this->planes[p] - axis) > sameAngle)
      all.emplace_back(2 * axis - this->planes[p], this->candela[p]);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  this->planes.clear();
  this->candela.clear();
  for (auto& [plane, row] : all)
  {
    this->planes.push_back(plane);
    this->candela.push_back(std::move(row));
  }
}

void PhotometryRows::mirrorAngles()
{
  const std::size_t shared = std::abs(this->angles.front()) < sameAngle ? 1 : 0;
  auto reflect = [&](const std::vector<double>& half, double sign) {
    std::vector<double> full(half.rbegin(), half.rend() - shared);
    for (double& value : full)
      value *= sign;
    full.insert(full.end(), half.begin(), half.end());
    return full;
  };
  this->angles = reflect(this->angles, -1);
  for (auto& row : this->candela)
    row = reflect(row, 1);
}

bool PhotometryRows::makeAscending()
{
  bool reversed = false;
  if (this->planes.size() > 1 && this->planes.front() > this->planes.back())
  {
    std::reverse(this->planes.begin(), this->planes.end());
    std::reverse(this->candela.begin(), this->candela.end());
    reversed = true;
  }
  if (this->angles.size() > 1 && this->angles.front() > this->angles.back())
  {
    std::reverse(this->angles.begin(), this->angles.end());
    for (auto& row : this->candela)
      std::reverse(row.begin(), row.end());
    reversed = true;
  }
  return reversed;
}

void PhotometryRows::scale(double factor)
{
  for (auto& row : this->candela)
    for (double& value : row)
      value *= factor;
}

CandelaTable PhotometryRows::table(CandelaTable::Pole pole) const
{
  std::vector<double> all;
  for (const auto& row : this->candela)
    all.insert(all.end(), row.begin(), row.end());
  return CandelaTable(this->planes, this->angles, std::move(all), pole);
}

void checkOrder(const std::vector<double>& values, int line, const std::string& field, bool mayDescend)
{
  const double sign = mayDescend && values.size() > 1 && values.front() > values.back() ? -1 : 1;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(sign * (values[i] - values[i - 1]) > sameAngle))
      throw PhotometryError(line, field,
                            "found " + shortNumber(values[i]) + " after " + shortNumber(values[i - 1]) +
                                "; expected angles in ascending order, none twice");
}

void checkCandela(const PhotometryRows& rows, int line)
{
  double largest = 0;
  for (std::size_t p = 0; p < rows.candela.size(); ++p)
    for (std::size_t a = 0; a < rows.angles.size(); ++a)
    {
      const double value = rows.candela[p][a];
      largest = std::max(largest, value);
      if (!(value >= 0 && value < 1e15))
        throw PhotometryError(line, "candela",
                              "found " + shortNumber(value) + " in plane " + shortNumber(rows.planes[p]) +
                                  " at angle " + shortNumber(rows.angles[a]) + "; expected 0 or more, below 1e15");
    }
  if (!(largest > 0))
    throw PhotometryError(line, "candela", "every intensity is 0; expected a luminaire that shines");
}
}  // namespace kalos
