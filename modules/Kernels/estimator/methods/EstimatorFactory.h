// SPDX-License-Identifier: BSD-3-Clause
// The estimator of each method.
#ifndef kalos_estimator_methods_EstimatorFactory_h
#define kalos_estimator_methods_EstimatorFactory_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/Estimator.h"

namespace kalos
{
/// The estimator of settings.method. Throws std::invalid_argument for invalid settings.
std::unique_ptr<Estimator> makeEstimator(const Scene& scene, const Receivers& receivers, const Settings& settings);
}  // namespace kalos

#endif
