// SPDX-License-Identifier: BSD-3-Clause
/** Receivers on a surface: its triangles, made small enough. */
#ifndef KalosSceneSurfaceReceivers_h
#define KalosSceneSurfaceReceivers_h

#include "../mesh/Mesh.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * Halve each triangle at its longest edge until no edge is longer than `edgeLength` (m). Cell normals are those of the
 * polygons, turned if `flip`. More than `most` triangles throw std::length_error with what is expected.
 */
vtkSmartPointer<vtkPolyData> makeSurfaceReceivers(const Mesh& mesh, double edgeLength, bool flip, std::int64_t most);
}  // namespace kalos::scene

#endif
