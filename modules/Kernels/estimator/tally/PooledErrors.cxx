// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/PooledErrors.h"

#include <algorithm>
#include <limits>

#include "geometry/SpatialOrder.h"

namespace kalos
{
PooledErrors::PooledErrors(const Receivers& receivers)
    : Order(spatialOrder(receivers.points, receivers.normals)), Points(receivers.points)
{
}

std::vector<double> PooledErrors::pool(const std::vector<double>& variances) const
{
  std::vector<std::size_t> fluctuating;
  for (const std::size_t r : this->Order)
    if (variances[r] > 0)
      fluctuating.push_back(r);
  std::vector<double> pooled(variances.size(), 0.0);
  std::vector<char> isOutlier(variances.size());
  for (std::size_t k = 0; k < fluctuating.size(); ++k)
  {
    const Mean others = this->neighbours(fluctuating, k, variances, {});
    const double variance = variances[fluctuating[k]];
    isOutlier[fluctuating[k]] = others.count > 0 && others.count * variance > outlier * others.sum;
  }
  for (std::size_t k = 0; k < fluctuating.size(); ++k)
  {
    const std::size_t r = fluctuating[k];
    const Mean others = this->neighbours(fluctuating, k, variances, isOutlier);
    pooled[r] = isOutlier[r] ? variances[r] : (variances[r] + others.sum) / (1 + others.count);
  }
  return pooled;
}

PooledErrors::Mean PooledErrors::neighbours(const std::vector<std::size_t>& order, std::size_t k,
                                            const std::vector<double>& variances,
                                            const std::vector<char>& leftOut) const
{
  const std::size_t first = k - std::min(k, around), last = std::min(order.size() - 1, k + around);
  double distance[2 * around + 1], nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i <= last; ++i)
  {
    distance[i - first] = length(this->Points[order[i]] - this->Points[order[k]]);
    if (i != k)
      nearest = std::min(nearest, distance[i - first]);
  }
  Mean found;
  for (std::size_t i = first; i <= last; ++i)
    if (i != k && distance[i - first] <= reach * nearest && (leftOut.empty() || !leftOut[order[i]]))
    {
      found.sum += variances[order[i]];
      found.count += 1;
    }
  return found;
}
}  // namespace kalos
