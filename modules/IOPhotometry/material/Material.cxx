// SPDX-License-Identifier: BSD-3-Clause
#include "Material.h"

#include <algorithm>
#include <cmath>

namespace kalos::scene
{
namespace
{
bool isFraction(double value)
{
  return value >= 0.0 && value < 1.0;
}
}  // namespace

std::string checkMaterial(const Material& material)
{
  const std::vector<double>& diffuse = material.reflectance;
  if (!std::all_of(diffuse.begin(), diffuse.end(), isFraction))
  {
    return "the reflectance is out of range; expected at least 0 and below 1";
  }
  if (!isFraction(material.specular) || !isFraction(material.mirror))
  {
    return "the specular or mirror reflectance is out of range; expected at least 0 and below 1";
  }
  if (!(material.roughness > 0.0 && material.roughness <= 1.0))
  {
    return "the roughness is out of range; expected above 0 and at most 1";
  }
  const std::vector<double>& exitance = material.exitance;
  if (!std::all_of(exitance.begin(), exitance.end(), [](double m) { return std::isfinite(m) && m >= 0.0; }))
  {
    return "the exitance is negative or not finite; expected at least 0 lm/m2";
  }
  const double most = *std::max_element(diffuse.begin(), diffuse.end());
  if (!(most + material.specular + material.mirror < 1.0))
  {
    return "reflectance + specular + mirror reach 1; expected a sum below 1";
  }
  return {};
}
}  // namespace kalos::scene
