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
 * Triangles of corner numbers that cover the polygon and keep its side. It may be concave, touch itself and have holes
 * that bridges join to the outline, edges that it runs along there and back; inside is what the outline goes around an
 * odd number of times, seen along the normal. None where two edges cross.
 */
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const std::vector<Point>& corners);
}  // namespace kalos::meshing

#endif
