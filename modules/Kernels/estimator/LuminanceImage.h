// SPDX-License-Identifier: BSD-3-Clause
// Luminance seen by a camera, (E2) for Lambertian surfaces: L = M0/pi + rho E(y)/pi with one estimate of E per pixel.
#ifndef kalos_estimator_LuminanceImage_h
#define kalos_estimator_LuminanceImage_h

#include "estimator/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
/// A pinhole camera, in world coordinates.
struct Camera
{
  Vec3 position, target, up{0, 0, 1};
  double fieldOfView = 45;  ///< vertical, degrees, in (0, 180)
  int width = 256, height = 256;
};

struct LuminanceResult
{
  int bands = 1;
  std::vector<double> luminance;       ///< cd/m2, photometric; row 0 at the bottom, 0 where nothing is seen
  std::vector<double> standardError;   ///< cd/m2
  std::vector<double> luminanceBands;  ///< cd/m2, bands values per pixel
  Result estimate;                     ///< of the illuminance behind it: trajectories, times, audit, aborted
};

/// Throws std::invalid_argument for a camera without meaning and for what solve() refuses.
LuminanceResult solveLuminance(const Scene& scene, const Camera& camera, const Settings& settings,
                               const Progress& progress = {});
}  // namespace kalos

#endif
