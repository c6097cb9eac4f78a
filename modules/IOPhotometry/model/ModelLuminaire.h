// SPDX-License-Identifier: BSD-3-Clause
/** Luminaires out of the lights of a model. */
#ifndef KalosModelLuminaire_h
#define KalosModelLuminaire_h

#include "Model.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/** A sphere around everything that parallel light has to reach. */
struct Ball
{
  Vector3 center{};
  double radius = 0.0;
};

/**
 * The luminaire that radiates as the light, like an output of vtkKalosLuminaireSource.
 *
 * - A point of I cd is isotropic with 4 pi I lm.
 * - A spot has the intensity that KHR_lights_punctual defines, I clamp((cos t - cos outer)/(cos inner - cos outer))^2,
 *   in a candela table of SpotSteps intervals between the two angles, which is within 1e-4 I of it.
 * - Parallel light of E lx comes from a point ParallelDistance radii of the ball away, whose narrow beam just covers
 *   it: E at the centre, and within 0.2 % of it in the ball.
 */
vtkSmartPointer<vtkPolyData> makeModelLuminaire(const ModelLight& light, const Ball& scene);

constexpr int SpotSteps = 128;
constexpr double ParallelDistance = 1000.0;
}  // namespace kalos::scene

#endif
