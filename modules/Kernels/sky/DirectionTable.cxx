// SPDX-License-Identifier: BSD-3-Clause
#include "sky/DirectionTable.h"

namespace kalos
{
namespace
{
Vec3 directionAt(double z, double azimuth)
{
  const double s = std::sqrt(std::max(0.0, 1 - z * z));
  return {s * std::cos(azimuth), s * std::sin(azimuth), z};
}

// Index drawn in proportion to the steps of a cumulative sum; u becomes what is left of it.
std::size_t draw(const double* cumulative, std::size_t count, double& u)
{
  const double target = u * cumulative[count - 1];
  const double* found = std::upper_bound(cumulative, cumulative + count, target);
  const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(found - cumulative), count - 1);
  const double before = i ? cumulative[i - 1] : 0, step = cumulative[i] - before;
  u = step > 0 ? std::clamp((target - before) / step, 0.0, 0x1.fffffffffffffp-1) : 0;
  return i;
}
}  // namespace

DirectionTable::DirectionTable(const std::function<double(const Vec3&)>& value) : Rows(rows), Cells(rows * columns)
{
  constexpr double cell = 4 * pi / (rows * columns);  // sr
  for (int i = 0; i < rows; ++i)
  {
    double sum = 0;
    for (int j = 0; j < columns; ++j)
    {
      double mean = 0;
      for (int k = 0; k < probes * probes; ++k)
        mean += value(directionAt(2 * (i + (k / probes + 0.5) / probes) / rows - 1,
                                  2 * pi * (j + (k % probes + 0.5) / probes) / columns)) /
                (probes * probes);
      this->Cells[i * columns + j] = sum += cell * mean;
    }
    this->Rows[i] = this->Total += sum;
  }
}

Vec3 DirectionTable::sample(double u1, double u2) const
{
  const std::size_t row = draw(this->Rows.data(), rows, u1);
  const std::size_t column = draw(&this->Cells[row * columns], columns, u2);
  return directionAt(2 * (static_cast<double>(row) + u1) / rows - 1,
                     2 * pi * (static_cast<double>(column) + u2) / columns);
}

double DirectionTable::density(const Vec3& direction) const
{
  if (this->isEmpty())
    return 0;
  const int row = std::clamp(static_cast<int>((direction.z + 1) / 2 * rows), 0, rows - 1);
  double turn = std::atan2(direction.y, direction.x) / (2 * pi);
  turn -= std::floor(turn);
  const int column = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
  const double* cells = &this->Cells[row * columns];
  const double share = (cells[column] - (column ? cells[column - 1] : 0)) / this->Total;
  return share * rows * columns / (4 * pi);
}
}  // namespace kalos
