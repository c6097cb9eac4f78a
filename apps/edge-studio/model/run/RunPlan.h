// SPDX-License-Identifier: BSD-3-Clause
// The steps of a run: previews first, then all receivers.
#ifndef studio_RunPlan_h
#define studio_RunPlan_h

#include <functional>
#include <vector>

#include "results/MethodSettings.h"
#include "scene/SceneDocument.h"
#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
struct RunStep
{
  MethodSettings settings;
  std::function<void()> prepare;  ///< of the estimator's inputs and size
  /// From what the estimator gives to what is shown; empty: the same.
  std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*)> makeOutput;
};

struct RunPlan
{
  vtkSmartPointer<vtkKalosEstimatorAlgorithm> estimator;  ///< one for all steps: it keeps the scene
  std::function<std::vector<RunStep>()> steps;            ///< made where they are run; the last is the whole
};

/// Illuminance at receivers; of up to 64 with the array IlluminanceReplicates too. With previews, of many, first some
/// that stand for all: 1200, 6000, 30 000.
RunPlan planReceivers(const SceneDocument& scene, vtkDataObject* receivers, const MethodSettings& settings,
                      bool previews = true);

/// Luminance seen by a camera, on `width` x `height` pixels; first on an eighth, a quarter and a half of the rows.
RunPlan planImage(const SceneDocument& scene, const CameraPreset& camera, int width, int height,
                  const MethodSettings& settings);
}  // namespace studio

#endif
