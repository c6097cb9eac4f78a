// SPDX-License-Identifier: BSD-3-Clause
/** The angles between the surfaces that meet along a line, and what they mean for the geometric kernel. */
#ifndef KalosMeshingEdgeAngles_h
#define KalosMeshingEdgeAngles_h

#include <vector>

#include "mesh/Vector.h"

namespace kalos::meshing
{
/** A half-plane that starts at the line: where it goes, at right angles to the line, and its surface's normal. Unit
 * vectors. */
struct Sheet
{
  Point direction;
  Point normal;
};

/** Dihedral angles, radians, 0 to 2 pi; infinity where no two surfaces face each other so. */
struct EdgeAngles
{
  double front;  ///< the smallest angle between two surfaces that face each other with their fronts
  double back;   ///< the smallest one between two backs
  bool mixed;    ///< no such pair: fronts face backs. `front` is then the smallest angle, `back` the rest of the circle
};

/**
 * Angles between neighbouring sheets around `axis`, a unit vector. Gaps of less than `flat` radians are closed:
 * surfaces that lie on each other let no light in between.
 */
EdgeAngles measureAngles(const Point& axis, const std::vector<Sheet>& sheets, double flat);

/**
 * cot²(α/2)/4: π times the geometric kernel cosθ cosθ'/(π d²) of two points, one on each wall of a concave edge, both
 * at unit distance from it; at distance s it is 1/s² times as much. 0 where the walls do not see each other (α ≥ π).
 */
double severity(double angle);
}  // namespace kalos::meshing

#endif
