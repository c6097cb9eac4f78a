// SPDX-License-Identifier: BSD-3-Clause
// Also known as: Morton order, Z-order curve (Morton 1966).
//
// Puts points in an order that keeps neighbours of similar orientation together: by the axis that the normal is nearest
// to, then along a curve that fills space. On a grid of 64 x 64, sixteen are a square of four; gather rays shared by
// sixteen in rows took 1.6 times longer to the same error on a floor, as long on walls.
#ifndef kalos_geometry_SpatialOrder_h
#define kalos_geometry_SpatialOrder_h

#include <cstddef>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
/// Indices of the points, each once; one unit normal per point.
std::vector<std::size_t> spatialOrder(const std::vector<Vec3>& points, const std::vector<Vec3>& normals);
}  // namespace kalos

#endif
