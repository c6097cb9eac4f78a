// SPDX-License-Identifier: BSD-3-Clause
/** From the metallic-roughness model of glTF 2.0 to Kalos's materials. */
#ifndef KalosMetallicRoughness_h
#define KalosMetallicRoughness_h

#include <array>
#include <optional>

#include "Material.h"

namespace kalos::scene
{
struct MetallicRoughness
{
  std::array<double, 3> baseColor{1.0, 1.0, 1.0};  ///< linear Rec. 709, [0,1]
  double metallic = 1.0;                           ///< [0,1]
  double roughness = 1.0;                          ///< [0,1]
  std::array<double, 3> luminance{};               ///< emitted, cd/m² per band
  /** Reflectance at normal incidence of the lobe, where a file gives it in place of metallic. */
  std::optional<double> specular = {};
};

/** Total reflectance at normal incidence that no model may exceed; the best of white paints stay below. */
constexpr double MaximumReflectance = 0.95;

/** Roughness from which on the 4 % that a dielectric's surface reflects count as part of its diffuse reflectance. */
constexpr double RoughSurface = 0.5;

/** What a conversion had to change. */
struct MaterialChanges
{
  bool limited = false;          ///< reflected more than MaximumReflectance
  bool neutralMetal = false;     ///< a coloured metal, whose lobe is neutral here
  bool roughDielectric = false;  ///< see RoughSurface
};

/**
 * Diffuse reflectance (1 - metallic) base colour; a lobe of normal-incidence reflectance F0 = 0.04 (1 - metallic) +
 * metallic Y(base colour) of the same roughness, or below roughness 0.02 a perfect mirror; exitance pi L. One band if
 * all colours are neutral. With a specular reflectance, the base colour is diffuse as far as the lobe leaves it, and F0
 * is that reflectance.
 */
Material convertMaterial(const MetallicRoughness& source, MaterialChanges& changes);

/** Luminance of a linear Rec. 709 colour. */
double luminanceOf(const std::array<double, 3>& color);
/** The components as bands, or one of them if they are equal. */
std::vector<double> bandsOf(const std::array<double, 3>& color);
/** Scale reflectance, specular and mirror so that their sum is within MaximumReflectance; whether that was needed. */
bool limitReflectance(Material& material);
}  // namespace kalos::scene

#endif
