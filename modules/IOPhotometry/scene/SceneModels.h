// SPDX-License-Identifier: BSD-3-Clause
/** The files among the "surfaces" of a scene file. */
#ifndef KalosSceneModels_h
#define KalosSceneModels_h

#include <set>
#include <string>

#include "SceneSurfaces.h"

namespace kalos::scene
{
/** The material that the key "material" names; null without the key. */
const Material* findMaterial(const JsonCursor& surface, const Materials& materials);

/** The key "file" of a surface with a name; `scale` and `up` place it. */
Mesh readSurfaceFile(const JsonCursor& node, const Materials& materials, const Material* material,
                     const std::string& folder, Notes& notes);

/**
 * Adds a model file whose parts become surfaces under their own names. Without the keys "up" and "scale", notes say
 * which axis is up, and that the unit may be wrong if the model is larger than buildings or smaller than furniture.
 */
void addModel(const JsonCursor& node, const Materials& materials, const std::string& folder,
              std::set<std::string>& names, SceneSurfaces& surfaces);
}  // namespace kalos::scene

#endif
