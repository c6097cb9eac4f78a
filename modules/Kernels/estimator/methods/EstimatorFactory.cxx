// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/EstimatorFactory.h"

#include <stdexcept>

#include "estimator/methods/CompensatedEstimation.h"
#include "estimator/methods/DirectSimulation.h"
#include "estimator/methods/FinalGathering.h"
#include "estimator/methods/LocalEstimation.h"
#include "estimator/methods/PathTracing.h"
#include "estimator/methods/PhotonMap.h"

namespace kalos
{
std::unique_ptr<Estimator> makeEstimator(const Scene& scene, const Receivers& receivers, const Settings& settings)
{
  switch (settings.method)
  {
    case Method::Local:
    case Method::SpherePublished:
    case Method::SphereExact:
    case Method::Disc:
    case Method::Clamped:
      return std::make_unique<LocalEstimation>(scene, receivers, settings);
    case Method::Compensated:
      return std::make_unique<CompensatedEstimation>(scene, receivers, settings);
    case Method::Gathered:
      return std::make_unique<FinalGathering>(scene, receivers, settings);
    case Method::Direct:
      return std::make_unique<DirectSimulation>(scene, receivers, settings);
    case Method::Paths:
      return std::make_unique<PathTracing>(scene, receivers, settings);
    case Method::PhotonMap:
      return std::make_unique<PhotonMap>(scene, receivers, settings);
    default:
      throw std::invalid_argument("method: does not exist");
  }
}
}  // namespace kalos
