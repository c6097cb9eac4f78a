// SPDX-License-Identifier: BSD-3-Clause
/**
 * Wavefront OBJ: polygons and the names of their materials. tinyobjloader silently accepts `v 1 2`
 * and `v 1 0x nan` and rejects continued lines; CGAL's reader drops materials and reports no line numbers.
 */
#ifndef KalosObjFile_h
#define KalosObjFile_h

#include <string>
#include <vector>

#include "../base/NoteCounter.h"
#include "Mesh.h"

namespace kalos::scene
{
/** Strict: for a scene, where nothing may be lost. Lenient: for the repair of a damaged mesh. */
enum class Reading
{
  Strict,
  Lenient
};

struct ObjFile
{
  Mesh polygons;                           ///< materialOf indexes materialNames, -1 where usemtl names none
  std::vector<std::string> materialNames;  ///< of usemtl
  std::vector<std::string> libraries;      ///< what mtllib statements name
  std::vector<std::string> objectNames;    ///< of o, or of g while no o was met; the first may be empty
  std::vector<std::size_t> objectOf;       ///< of each polygon in objectNames
};

/**
 * Read v, f (polygons of any size, negative indices, a/b/c forms; also by its old name fo), usemtl, mtllib, o and g.
 * Statements of appearance, lines, points and curves do not affect light and are ignored. Curved surfaces and
 * unknown statements are errors, or with Reading::Lenient counted in `notes`. Faces of fewer than three corners are
 * kept for Mesh::dropDegenerate. Names reach to the end of their line, with any `#` in them.
 */
ObjFile readObjFile(const std::string& path, Notes& notes, Reading reading = Reading::Strict);
}  // namespace kalos::scene

#endif
