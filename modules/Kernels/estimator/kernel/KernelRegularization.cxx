// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/kernel/KernelRegularization.h"

#include <stdexcept>

namespace kalos
{
namespace
{
constexpr double ratio = 0.6;     // of epsilon to delta, as in the paper's Table 1
constexpr double spacings = 1.4;  // mean distances of vertices in epsilon
}  // namespace

Neighbourhood neighbourhood(const Scene& scene, const Settings& settings, double vertices)
{
  auto require = [&](double value, const char* name) {
    if (!(value >= 0 && value <= scene.size()))
      throw std::invalid_argument(std::string(name) + ": is " + std::to_string(value) +
                                  " m, expected 0 (automatic) up to the size of the scene, " +
                                  std::to_string(scene.size()) + " m");
  };
  require(settings.delta, "delta");
  require(settings.epsilon, "epsilon");
  const double largest = scene.size() / 4, spacing = vertices > 0 ? 1 / std::sqrt(vertices) : largest;
  const double given = settings.epsilon > 0 ? settings.epsilon : ratio * settings.delta;
  const double epsilon = given > 0 ? given : std::min(largest, spacings * spacing);
  return {settings.delta > 0 ? settings.delta : epsilon / ratio, epsilon};
}
}  // namespace kalos
