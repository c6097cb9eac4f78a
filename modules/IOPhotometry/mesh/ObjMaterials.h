// SPDX-License-Identifier: BSD-3-Clause
/** The materials that an OBJ names. */
#ifndef KalosObjMaterials_h
#define KalosObjMaterials_h

#include "../base/Notes.h"
#include "ObjFile.h"

namespace kalos::scene
{
/**
 * The materials that the OBJ at `path` names, in its order: from `overrides`, else from its libraries. A name that is
 * nowhere is an error.
 */
std::vector<Material> findObjMaterials(const std::string& path, const ObjFile& file, const Materials& overrides,
                                       Notes& notes);
}  // namespace kalos::scene

#endif
