// SPDX-License-Identifier: BSD-3-Clause
// What a surface does with light.
#ifndef kalos_material_Material_h
#define kalos_material_Material_h

#include "photometry/Bands.h"

namespace kalos
{
/// A two-sided Lambertian reflector that may emit on the side of its normal.
struct Material
{
  Bands reflectance{};  ///< diffuse reflectance rho per band, [0, 1)
  Bands exitance{};     ///< M0 per band, lm/m2, >= 0, emitted on the side of the normal

  bool operator==(const Material& other) const
  {
    return this->reflectance == other.reflectance && this->exitance == other.exitance;
  }
};
}  // namespace kalos

#endif
