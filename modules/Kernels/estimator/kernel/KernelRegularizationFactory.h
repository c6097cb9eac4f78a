// SPDX-License-Identifier: BSD-3-Clause
// The regularization of each method.
#ifndef kalos_estimator_kernel_KernelRegularizationFactory_h
#define kalos_estimator_kernel_KernelRegularizationFactory_h

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/kernel/KernelRegularization.h"

namespace kalos
{
/// Null for the methods that keep the plain kernel. `vertices` per m2 are what the whole solve will leave.
std::unique_ptr<KernelRegularization> makeRegularization(const Scene& scene, const Receivers& receivers,
                                                         const Settings& settings, double vertices);
}  // namespace kalos

#endif
