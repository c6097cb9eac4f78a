// SPDX-License-Identifier: BSD-3-Clause
// Also known as: pooled variance.
//
// The variance of P replicates is known to a relative error of sqrt(2/(P-1)): a half where there are eight. Neighbours
// see nearly the same light, so the mean over nine of them is known to a sixth. A receiver whose own variance is five
// times that of its neighbours (by chance 2 in 10 000, F test) is at an edge or a shadow border: it keeps its own, and
// its neighbours are averaged without it.
#ifndef kalos_estimator_tally_PooledErrors_h
#define kalos_estimator_tally_PooledErrors_h

#include <cstddef>
#include <vector>

#include "estimator/control/Receivers.h"

namespace kalos
{
class PooledErrors
{
public:
  static constexpr std::size_t around = 4;  ///< neighbours on either side, in the order of geometry/SpatialOrder.h
  static constexpr double reach = 5;        ///< times the distance of the nearest, beyond which a point is no neighbour
  static constexpr double outlier = 5;      ///< own variance over the neighbours', above which it is kept

  explicit PooledErrors(const Receivers& receivers);

  /// One variance per receiver, in a unit that makes neighbours comparable. Receivers of variance 0 do not fluctuate:
  /// they keep it and are no neighbours.
  std::vector<double> pool(const std::vector<double>& variances) const;

private:
  struct Mean
  {
    double sum = 0, count = 0;
  };
  // The neighbours of order[k], without those `leftOut` (empty: none).
  Mean neighbours(const std::vector<std::size_t>& order, std::size_t k, const std::vector<double>& variances,
                  const std::vector<char>& leftOut) const;

  std::vector<std::size_t> Order;
  std::vector<Vec3> Points;
};
}  // namespace kalos

#endif
