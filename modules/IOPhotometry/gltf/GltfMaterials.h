// SPDX-License-Identifier: BSD-3-Clause
/** The materials of a glTF. */
#ifndef KalosGltfMaterials_h
#define KalosGltfMaterials_h

#include <vector>

#include "../base/Notes.h"
#include "../material/Material.h"
#include "GltfFile.h"

namespace kalos::scene
{
/**
 * One material each of the file's, or the one of `overrides` that has its name. Textures count by their mean colour
 * times the factor beside them. What is approximated is added to `notes`.
 */
std::vector<Material> readGltfMaterials(const GltfFile& file, const Materials& overrides, Notes& notes);
}  // namespace kalos::scene

#endif
