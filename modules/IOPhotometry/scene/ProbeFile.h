// SPDX-License-Identifier: BSD-3-Clause
/** Receivers listed in a CSV file. */
#ifndef KalosSceneProbeFile_h
#define KalosSceneProbeFile_h

#include <string>

#include "SceneJson.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace kalos::scene
{
/**
 * Read the header `x,y,z,nx,ny,nz` and one receiver a line, position in m and normal of any length; blank lines are
 * passed over. The output has vertices and point normals of unit length. `place` is the scene's value with the path.
 */
vtkSmartPointer<vtkPolyData> ReadProbeFile(const Node& place, const std::string& path);
}  // namespace kalos::scene

#endif
