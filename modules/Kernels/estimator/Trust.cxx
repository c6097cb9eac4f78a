// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Trust.h"

#include <algorithm>

#include "sampling/Sobol.h"
#include "sampling/Warp.h"

namespace kalos
{
bool tailIsLight(double largestScoreShare, const MeanAndError& estimate)
{
  return largestScoreShare * std::abs(estimate.mean) <= std::sqrt(0.5) * estimate.standardError ||
         largestScoreShare == 0;
}

double nearKernel(const Scene& scene, const Sensor& sensor)
{
  constexpr int probes = 64;
  std::array<double, probes> kernels{};
  const Frame frame(sensor.normal);
  for (int i = 0; i < probes; ++i)
  {
    double u1, u2;
    sobolPoint(1, static_cast<std::uint32_t>(i), u1, u2);
    const Vec3 direction = frame.toWorld(cosineHemisphere(u1, u2));
    const SurfacePoint y = scene.trace(sensor.position, sensor.normal, direction);
    if (!y.valid)
      continue;
    const Vec3 d = y.position - sensor.position;
    kernels[i] = dot(direction, sensor.normal) * -dot(direction, y.normal) / (pi * dot(d, d));
  }
  std::nth_element(kernels.begin(), kernels.begin() + 2, kernels.end(), std::greater<double>());
  return kernels[2];
}

bool nearFieldIsSeen(double nearKernel, double density)
{
  return density >= 10 * nearKernel;
}
}  // namespace kalos
