// SPDX-License-Identifier: BSD-3-Clause
/** The materials that an OBJ names. */
#ifndef KalosObjMaterials_h
#define KalosObjMaterials_h

#include "../base/Notes.h"
#include "ObjFile.h"

namespace kalos::scene
{
/**
 * Give the polygons of the OBJ at `path` the materials that it names: from `overrides`, else from its libraries. A name
 * that is nowhere is an error if they are `required`; else its polygons have no material (-1), and `notes` tell.
 * A mtllib statement may name several libraries; a name may be followed by blanks, `#` and a comment.
 */
void useObjMaterials(const std::string& path, ObjFile& file, const Materials& overrides, bool required, Notes& notes);
}  // namespace kalos::scene

#endif
