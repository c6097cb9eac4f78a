// SPDX-License-Identifier: BSD-3-Clause
/** Receivers listed in a CSV file. */
#ifndef KalosSceneProbeFile_h
#define KalosSceneProbeFile_h

#include <string>

#include "../base/JsonCursor.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
constexpr std::size_t MaximumProbeLine = 1024;

/**
 * Read the header `x,y,z,nx,ny,nz` and one receiver a line, position in m and normal of any length; blank lines are
 * passed over. The output has vertices and point normals of unit length. `place` is the scene's value with the path.
 * More than `most` receivers, and lines longer than MaximumProbeLine bytes, are errors.
 */
vtkSmartPointer<vtkPolyData> readProbeFile(const JsonCursor& place, const std::string& path, std::int64_t most);
}  // namespace kalos::scene

#endif
