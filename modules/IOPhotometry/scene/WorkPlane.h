// SPDX-License-Identifier: BSD-3-Clause
/** The default calculation plane of a model without receivers. */
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
  double low[2];
  double high[2];
  double height;
  double floor;
};

/**
 * The plane WorkHeight above the floor over the extent of the floor. The floor is the level of the largest area among
 * horizontal faces, within 1 cm, in the lower third of the model: of faces that look up, or of all if none does. None
 * if there is no floor, or the model ends below the plane.
 */
std::optional<WorkPlane> findWorkPlane(const std::vector<Surface>& surfaces, double top);
}  // namespace kalos::scene

#endif
