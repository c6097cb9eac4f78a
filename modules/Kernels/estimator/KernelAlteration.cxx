// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/KernelAlteration.h"

#include <stdexcept>

#include "estimator/Clamped.h"
#include "estimator/DiscAverage.h"
#include "estimator/SphereAverage.h"

namespace kalos
{
Neighbourhood neighbourhood(const Scene& scene, const Settings& settings)
{
  auto require = [&](double value, const char* name) {
    if (!(value >= 0 && value <= scene.size()))
      throw std::invalid_argument(std::string(name) + ": is " + std::to_string(value) +
                                  " m, expected 0 (automatic) up to the size of the scene, " +
                                  std::to_string(scene.size()) + " m");
  };
  require(settings.delta, "delta");
  require(settings.epsilon, "epsilon");
  const double delta = settings.delta > 0 ? settings.delta : scene.size() / 20;
  return {delta, settings.epsilon > 0 ? settings.epsilon : 0.6 * delta};
}

std::unique_ptr<KernelAlteration> makeAlteration(const Scene& scene, const Receivers& receivers,
                                                 const Settings& settings)
{
  const Neighbourhood near = neighbourhood(scene, settings);
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
