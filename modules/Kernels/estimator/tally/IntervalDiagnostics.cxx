// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/IntervalDiagnostics.h"

#include <algorithm>

#include "estimator/tally/ProbeRays.h"

namespace kalos
{
bool tailIsLight(double largestScoreShare, bool standsOut, const MeanAndError& estimate)
{
  return !standsOut || largestScoreShare * std::abs(estimate.mean) <= std::sqrt(0.5) * estimate.standardError ||
         largestScoreShare == 0;
}

double nearKernel(const Scene& scene, const Sensor& sensor)
{
  constexpr int probes = 64;
  std::array<double, probes> kernels{};
  std::size_t met = 0;
  sendProbes(scene, sensor, probes, [&](double kernel, const Vec3&) { kernels[met++] = kernel; });
  std::nth_element(kernels.begin(), kernels.begin() + 2, kernels.end(), std::greater<double>());
  return kernels[2];
}

bool hiddenIsLittle(const PickCount& picks, double samples, const MeanAndError& estimate)
{
  constexpr double enough = 16, little = 0.05;
  if (picks.seen >= enough || !(picks.tried > 0))
    return true;
  const double perPick = picks.possible / picks.tried / samples;
  return (3 + 1.7 * std::sqrt(picks.seen)) * perPick <=
         std::max(2 * estimate.standardError, little * std::abs(estimate.mean));
}

bool nearFieldIsSeen(double nearKernel, double density)
{
  return density >= 10 * nearKernel;
}
}  // namespace kalos
