// SPDX-License-Identifier: BSD-3-Clause
/** How a polygon reflects and emits. */
#ifndef KalosMaterial_h
#define KalosMaterial_h

#include <map>
#include <string>
#include <vector>

namespace kalos::scene
{
constexpr double PlainGlass = 1.52;  ///< refractive index

/** Of one polygon. Reflectance and Exitance have 1 or n components, one a band. */
struct Material
{
  std::vector<double> reflectance{0.0};  ///< diffuse, [0,1)
  std::vector<double> exitance{0.0};     ///< lm/m²
  double specular = 0.0;                 ///< normal-incidence reflectance of the glossy lobe, [0,1)
  double roughness = 1.0;                ///< GGX roughness, (0,1]
  double mirror = 0.0;                   ///< [0,1)
  double transmittance = 0.0;            ///< of a pane of glass at normal incidence, (0,1]; 0: opaque
  double refractiveIndex = PlainGlass;   ///< of such a pane
};

using Materials = std::map<std::string, Material>;

/** The highest transmittance of a pane of this refractive index: without absorption. */
double clearestGlass(double index);

/** Empty if all numbers are in range, else what is wrong and what is expected. */
std::string checkMaterial(const Material& material);
}  // namespace kalos::scene

#endif
