// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/KernelRegularizationFactory.h"

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/kernel/Clamped.h"
#include "estimator/kernel/DiscAverage.h"
#include "estimator/kernel/SphereAverage.h"

namespace kalos
{
std::unique_ptr<KernelRegularization> makeRegularization(const Scene& scene, const Receivers& receivers,
                                                         const Settings& settings, double vertices)
{
  const Neighbourhood near = neighbourhood(scene, settings, vertices);
  switch (settings.method)
  {
    case Method::SpherePublished:
      return std::make_unique<SphereAverage>(near.delta, near.epsilon, SphereChoices{false, true});
    case Method::SphereExact:
      return std::make_unique<SphereAverage>(near.delta, near.epsilon, SphereChoices{true, true});
    case Method::Disc:
      return std::make_unique<DiscAverage>(scene, receivers, near.epsilon);
    case Method::Clamped:
      return std::make_unique<Clamped>(near.delta);
    default:
      return nullptr;
  }
}
}  // namespace kalos
