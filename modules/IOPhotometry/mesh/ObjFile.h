// SPDX-License-Identifier: BSD-3-Clause
/** Wavefront OBJ: polygons and the names of their materials. VTK's reader keeps neither double precision nor line
 * numbers. */
#ifndef KalosObjFile_h
#define KalosObjFile_h

#include <string>
#include <vector>

#include "Mesh.h"

namespace kalos::scene
{
struct ObjFile
{
  Mesh polygons;                           ///< MaterialOf indexes MaterialNames, -1 before the first usemtl
  std::vector<std::string> materialNames;  ///< of usemtl
  std::vector<std::string> libraries;      ///< of mtllib
  std::vector<std::string> objectNames;    ///< of o, or of g while no o was met; the first may be empty
  std::vector<std::size_t> objectOf;       ///< of each polygon in ObjectNames
};

/**
 * Read v, f (polygons of any size, negative indices, a/b/c forms), usemtl, mtllib, o and g. Texture coordinates,
 * normals, smoothing, lines and points do not concern light and are passed over; anything else is an error.
 */
ObjFile readObjFile(const std::string& path);
}  // namespace kalos::scene

#endif
