// SPDX-License-Identifier: BSD-3-Clause
#include "MetallicRoughness.h"

#include <algorithm>
#include <cmath>

namespace kalos::scene
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double DielectricReflectance = 0.04;
constexpr double SmoothMirror = 0.02;
}  // namespace

double luminanceOf(const std::array<double, 3>& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

std::vector<double> bandsOf(const std::array<double, 3>& color)
{
  const bool neutral = color[0] == color[1] && color[1] == color[2];
  return neutral ? std::vector<double>{color[0]} : std::vector<double>(color.begin(), color.end());
}

bool limitReflectance(Material& material)
{
  const double most = *std::max_element(material.reflectance.begin(), material.reflectance.end());
  const double total = most + material.specular + material.mirror;
  if (total <= MaximumReflectance)
  {
    return false;
  }
  const double factor = MaximumReflectance / total;
  for (double& reflectance : material.reflectance)
  {
    reflectance *= factor;
  }
  material.specular *= factor;
  material.mirror *= factor;
  return true;
}

Material convertMaterial(const MetallicRoughness& source, MaterialChanges& changes)
{
  const double metallic = source.specular ? *source.specular : std::clamp(source.metallic, 0.0, 1.0);
  const double roughness = std::clamp(source.roughness, 0.0, 1.0);
  std::array<double, 3> diffuse{}, exitance{};
  for (int c = 0; c < 3; ++c)
  {
    diffuse[c] = (1.0 - metallic) * std::clamp(source.baseColor[c], 0.0, 1.0);
    exitance[c] = Pi * source.luminance[c];
  }
  const bool roughDielectric = !source.specular && metallic < 1.0 && roughness >= RoughSurface;
  const double dielectric = roughDielectric ? 0.0 : (1.0 - metallic) * DielectricReflectance;
  const double lobe = source.specular ? metallic : metallic * luminanceOf(source.baseColor) + dielectric;
  Material material;
  material.reflectance = bandsOf(diffuse);
  material.exitance = bandsOf(exitance);
  material.roughness = std::max(roughness, SmoothMirror);
  (roughness < SmoothMirror ? material.mirror : material.specular) = lobe;
  changes.neutralMetal = !source.specular && metallic > 0.0 && bandsOf(source.baseColor).size() > 1;
  changes.roughDielectric = roughDielectric;
  changes.limited = limitReflectance(material);
  return material;
}
}  // namespace kalos::scene
