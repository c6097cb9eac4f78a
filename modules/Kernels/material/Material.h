// SPDX-License-Identifier: BSD-3-Clause
// What a surface does with light.
#ifndef kalos_material_Material_h
#define kalos_material_Material_h

#include <memory>

#include "material/Glass.h"
#include "photometry/Bands.h"

namespace kalos
{
/// A two-sided reflector: a diffuse part, a glossy GGX lobe and a perfect mirror share; it may emit on the side of its
/// normal; or a pane of glass, which does nothing else. The sum of reflectance, specular and mirror stays below 1.
/// material/Brdf.h has the formulas.
struct Material
{
  Bands reflectance{};   ///< diffuse reflectance rho per band, [0, 1)
  Bands exitance{};      ///< M0 per band, lm/m2, >= 0, emitted on the side of the normal
  double specular = 0;   ///< reflectance of the glossy lobe at normal incidence F0, [0, 1), neutral
  double roughness = 1;  ///< of the glossy lobe, (0, 1]; the GGX width is its square, as in glTF
  double mirror = 0;     ///< share reflected as by a perfect mirror, [0, 1), neutral

  std::shared_ptr<const Glass> glass;  ///< null: opaque

  bool isLambertian() const { return this->specular == 0 && this->mirror == 0; }
};
}  // namespace kalos

#endif
