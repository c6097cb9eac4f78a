// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Estimator.h"

#include <stdexcept>

#include "estimator/DirectSimulation.h"
#include "estimator/LocalEstimation.h"

namespace kalos
{
std::unique_ptr<Estimator> makeEstimator(const Scene& scene, const Receivers& receivers, const Settings& settings)
{
  switch (settings.method)
  {
    case Method::Local:
      return std::make_unique<LocalEstimation>(scene, receivers, settings);
    case Method::Direct:
      return std::make_unique<DirectSimulation>(scene, receivers, settings);
    default:
      throw std::invalid_argument("method: only local and direct are available");
  }
}
}  // namespace kalos
