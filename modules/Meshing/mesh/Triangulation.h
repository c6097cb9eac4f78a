// SPDX-License-Identifier: BSD-3-Clause
/** Polygons cut into triangles. */
#ifndef KalosMeshingTriangulation_h
#define KalosMeshingTriangulation_h

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/Vector.h"

namespace kalos::meshing
{
/** Whether a fan from the first corner covers the polygon. */
bool isConvex(const std::vector<Point>& corners);

/**
 * Triangulates a polygon and keeps its orientation; returns corner indices. The polygon may be concave, touch itself
 * and have holes that bridge edges connect to the outline (each traversed in both directions). The even-odd rule
 * decides what is inside. Empty if two edges cross.
 */
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const std::vector<Point>& corners);
}  // namespace kalos::meshing

#endif
