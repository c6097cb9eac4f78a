// SPDX-License-Identifier: BSD-3-Clause
#include "Material.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace kalos::scene
{
namespace
{
bool isFraction(double value)
{
  return value >= 0.0 && value < 1.0;
}

std::string checkGlass(double transmittance, double index)
{
  if (!(index >= 1.0 && index <= 4.0))
  {
    return "the refractive index is out of range; expected 1 to 4";
  }
  if (!(transmittance > 0.0 && transmittance <= 1.0))
  {
    return "the transmittance is out of range; expected above 0 and at most 1";
  }
  const double clearest = clearestGlass(index);
  if (transmittance > clearest * (1.0 + 1e-9))
  {
    std::ostringstream text;
    text << "the transmittance is " << transmittance << ", but the two sides of a refractive index of " << index
         << " reflect so much that " << clearest << " is the highest; expected no more";
    return text.str();
  }
  return {};
}
}  // namespace

double clearestGlass(double index)
{
  const double side = (index - 1.0) * (index - 1.0) / ((index + 1.0) * (index + 1.0));
  return (1.0 - side) / (1.0 + side);
}

std::string checkMaterial(const Material& material)
{
  if (material.transmittance != 0.0)
  {
    return checkGlass(material.transmittance, material.refractiveIndex);
  }
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
