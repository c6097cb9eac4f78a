// SPDX-License-Identifier: BSD-3-Clause
// Luminance seen by a camera, the double local estimate (E2): L = M0/pi + sum f_r(y) f_r(y_i) cos cos' w_i V / d^2 at
// the first surface point y on the line of sight, mirrors followed. For a Lambertian y the inner sum is rho E(y)/pi; a
// glossy y weighs it by its BRDF, and with method `compensated` its gather rays are drawn from the BRDF, balanced
// against the vertices.
#ifndef kalos_estimator_quantities_LuminanceImage_h
#define kalos_estimator_quantities_LuminanceImage_h

#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "scene/Scene.h"

namespace kalos
{
/// A pinhole camera, in world coordinates.
struct Camera
{
  Vec3 position, target, up{0, 0, 1};
  double fieldOfView = 45;  ///< vertical, degrees, in (0, 180)
  int width = 256, height = 256;
  /// Lines of sight in a pixel beside an edge: where it and its neighbours see other surfaces or normals, or a step in
  /// depth, also in mirrors. Elsewhere a pixel has one, through its centre. 1: everywhere.
  int pixelSamples = 16;
};

struct LuminanceResult
{
  int bands = 1;
  std::vector<double> luminance;       ///< cd/m2, photometric; row 0 at the bottom, 0 where nothing is seen
  std::vector<double> standardError;   ///< cd/m2
  std::vector<double> luminanceBands;  ///< cd/m2, bands values per pixel
  std::vector<char>
      trusted;      ///< 1 where the standard error can be believed; rule in estimator/tally/IntervalDiagnostics.h
  Result estimate;  ///< of the illuminance behind it: trajectories, times, audit, aborted
};

/// Called after each round with the image so far.
using ImageSnapshot = std::function<void(const LuminanceResult&)>;

/// Without a goal and a limit it runs 1024 trajectories per pixel. Luminaires have no body: the camera sees them only
/// in mirrors. Throws std::invalid_argument for an invalid camera and for input that solve() rejects.
LuminanceResult solveLuminance(const Scene& scene, const Camera& camera, const Settings& settings,
                               const Progress& progress = {}, const ImageSnapshot& snapshot = {});
}  // namespace kalos

#endif
