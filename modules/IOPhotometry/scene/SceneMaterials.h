// SPDX-License-Identifier: BSD-3-Clause
/** The "materials" of a scene file. */
#ifndef KalosSceneMaterials_h
#define KalosSceneMaterials_h

#include "../base/JsonCursor.h"
#include "../material/Material.h"

namespace kalos::scene
{
/** Read the object "materials"; the sum of the three reflectances stays below 1 in every band. */
Materials readMaterials(const JsonCursor& scene);
}  // namespace kalos::scene

#endif
