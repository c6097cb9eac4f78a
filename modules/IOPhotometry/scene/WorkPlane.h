// SPDX-License-Identifier: BSD-3-Clause
/** Where a lighting engineer looks first in a model that says nothing of it. */
#ifndef KalosWorkPlane_h
#define KalosWorkPlane_h

#include <optional>

#include "SceneSurfaces.h"

namespace kalos::scene
{
constexpr double WorkHeight = 0.75;  ///< m above the floor

/** A horizontal rectangle, its height, and the height of the floor below it, m. */
struct WorkPlane
{
  double Low[2];
  double High[2];
  double Height;
  double Floor;
};

/**
 * The plane WorkHeight above the floor over the extent of the floor. The floor is the level of the largest area among
 * horizontal faces, within 1 cm, in the lower third of the model: of faces that look up, or of all if none does. None
 * if there is no floor, or the model ends below the plane.
 */
std::optional<WorkPlane> FindWorkPlane(const std::vector<Surface>& surfaces, double top);
}  // namespace kalos::scene

#endif
