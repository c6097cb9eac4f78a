// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/Replicates.h"

#include <algorithm>
#include <cmath>

namespace kalos
{
MeanAndError summarise(const double* replicates, std::size_t count)
{
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double delta = replicates[i] - mean;
    mean += delta / static_cast<double>(i + 1);
    squares += delta * (replicates[i] - mean);
  }
  const double n = static_cast<double>(count);
  return {mean, count > 1 ? std::sqrt(squares / (n - 1) / n) : 0};
}

namespace
{
// P(|t| <= x) for integer degrees of freedom (Abramowitz and Stegun 26.7.3, 26.7.4).
double studentCentral(double x, int freedom)
{
  const double theta = std::atan(x / std::sqrt(static_cast<double>(freedom)));
  const double c = std::cos(theta), s = std::sin(theta);
  double term = freedom % 2 ? c : 1, sum = freedom == 1 ? 0 : term;
  for (int k = freedom % 2 ? 3 : 2; k < freedom - 1; k += 2)
  {
    term *= c * c * (k - 1) / k;
    sum += term;
  }
  return freedom % 2 ? 2 / 3.14159265358979323846 * (theta + s * sum) : s * sum;
}
}  // namespace

double studentQuantile(double level, int freedom)
{
  double low = 0, high = 1;
  while (studentCentral(high, freedom) < level)
    high *= 2;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (studentCentral(middle, freedom) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

namespace
{
// The largest divisor of the trajectories from `most` down to `least`, else `most`; below, one for each.
int divisor(long long trajectories, int most, int least)
{
  if (trajectories < most)
    return static_cast<int>(std::max(2LL, trajectories));
  for (int p = most; p >= least; --p)
    if (trajectories % p == 0)
      return p;
  return most;
}
}  // namespace

int replicateCount(long long trajectories)
{
  return divisor(trajectories, 32, 16);
}

int fewReplicates(long long trajectories)
{
  return divisor(trajectories, 8, 5);
}
}  // namespace kalos
