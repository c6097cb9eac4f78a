// SPDX-License-Identifier: BSD-3-Clause
/** An OBJ with its material libraries as a model. */
#ifndef KalosObjModel_h
#define KalosObjModel_h

#include <string>

#include "../scene/ObjFile.h"
#include "ModelUse.h"

namespace kalos::scene
{
/** A part per object ("o", or "g" where there are none). Throws SceneError. */
Model ReadObjModel(const std::string& path, const ModelUse& use);

/**
 * The materials that the OBJ at `path` names, in its order: from `overrides`, else from its libraries. A name that is
 * nowhere is an error.
 */
std::vector<Material> FindObjMaterials(const std::string& path, const ObjFile& file, const Materials& overrides,
                                       Notes& notes);
}  // namespace kalos::scene

#endif
