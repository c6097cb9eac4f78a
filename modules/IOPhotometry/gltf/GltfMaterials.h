// SPDX-License-Identifier: BSD-3-Clause
/** The materials of a glTF. */
#ifndef KalosGltfMaterials_h
#define KalosGltfMaterials_h

#include <optional>
#include <vector>

#include "../base/Notes.h"
#include "../material/Material.h"
#include "../material/MetallicRoughness.h"
#include "GltfFile.h"

namespace kalos::scene
{
struct GltfMaterial
{
  Material material;
  /** The source of `material`; empty if the scene overrides it. */
  std::optional<MetallicRoughness> source;
  bool emitsOnBothSides = false;
};

/** Multiplies the base colour, as vertex colours do; a material that the scene overrides stays as it is. */
Material multiplyBaseColor(const GltfMaterial& material, const std::array<double, 3>& color);

/**
 * One material each of the file's, or the one of `overrides` that has its name. Textures count by their mean colour
 * times the factor beside them; KHR_materials_pbrSpecularGlossiness is read as well. What is approximated is added to
 * `notes`.
 */
std::vector<GltfMaterial> readGltfMaterials(const GltfFile& file, const Materials& overrides, Notes& notes);
}  // namespace kalos::scene

#endif
