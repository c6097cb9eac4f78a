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

double LuminanceOf(const std::array<double, 3>& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

std::vector<double> BandsOf(const std::array<double, 3>& color)
{
  const bool neutral = color[0] == color[1] && color[1] == color[2];
  return neutral ? std::vector<double>{color[0]} : std::vector<double>(color.begin(), color.end());
}

bool LimitReflectance(Material& material)
{
  const double most = *std::max_element(material.Reflectance.begin(), material.Reflectance.end());
  const double total = most + material.Specular + material.Mirror;
  if (total <= MaximumReflectance)
  {
    return false;
  }
  const double factor = MaximumReflectance / total;
  for (double& reflectance : material.Reflectance)
  {
    reflectance *= factor;
  }
  material.Specular *= factor;
  material.Mirror *= factor;
  return true;
}

Material ConvertMaterial(const MetallicRoughness& source, MaterialChanges& changes)
{
  const double metallic = std::clamp(source.Metallic, 0.0, 1.0);
  const double roughness = std::clamp(source.Roughness, 0.0, 1.0);
  std::array<double, 3> diffuse{}, exitance{};
  for (int c = 0; c < 3; ++c)
  {
    diffuse[c] = (1.0 - metallic) * std::clamp(source.BaseColor[c], 0.0, 1.0);
    exitance[c] = Pi * source.Luminance[c];
  }
  const bool roughDielectric = metallic < 1.0 && roughness >= RoughSurface;
  const double lobe =
      metallic * LuminanceOf(source.BaseColor) + (roughDielectric ? 0.0 : (1.0 - metallic) * DielectricReflectance);
  Material material;
  material.Reflectance = BandsOf(diffuse);
  material.Exitance = BandsOf(exitance);
  material.Roughness = std::max(roughness, SmoothMirror);
  (roughness < SmoothMirror ? material.Mirror : material.Specular) = lobe;
  changes.NeutralMetal = metallic > 0.0 && BandsOf(source.BaseColor).size() > 1;
  changes.RoughDielectric = roughDielectric;
  changes.Limited = LimitReflectance(material);
  return material;
}
}  // namespace kalos::scene
