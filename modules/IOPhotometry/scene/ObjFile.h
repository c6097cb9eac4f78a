// SPDX-License-Identifier: BSD-3-Clause
/** Wavefront OBJ: polygons and the names of their materials. VTK's reader keeps neither double precision nor line
 * numbers. */
#ifndef KalosSceneObjFile_h
#define KalosSceneObjFile_h

#include <string>
#include <vector>

#include "Mesh.h"

namespace kalos::scene
{
/**
 * Read v, f (polygons of any size, negative indices, a/b/c forms) and usemtl. Texture coordinates, normals, groups,
 * smoothing, libraries, lines and points do not concern light and are passed over; anything else is an error.
 * MaterialOf indexes `materialNames`, -1 before the first usemtl.
 */
Mesh ReadObjFile(const std::string& path, std::vector<std::string>& materialNames);
}  // namespace kalos::scene

#endif
