// SPDX-License-Identifier: BSD-3-Clause
/** Edge lengths adapted to a previous result. */
#ifndef KalosResultLengths_h
#define KalosResultLengths_h

#include <string>
#include <vector>

#include "mesh/TriangleMesh.h"

class vtkPolyData;

namespace kalos
{
/**
 * By cell of `input`: the length L' = L c m / (L |g| + s), at most L and at least L/8, where L is `edgeLength`, c the
 * `change` that is allowed along an edge relative to the mean m of the cell array `name`, g the steepest slope towards
 * a neighbour, and s the cell's entry of the array `name`StandardError, if there is one. Throws std::invalid_argument
 * if there is no such array of one component, or if it holds values that are not finite.
 */
std::vector<double> lengthsForResult(vtkPolyData* input, const meshing::TriangleMesh& mesh, const std::string& name,
                                     double change, double edgeLength);
}  // namespace kalos

#endif
