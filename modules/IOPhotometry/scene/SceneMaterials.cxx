// SPDX-License-Identifier: BSD-3-Clause
#include "SceneMaterials.h"

namespace kalos::scene
{
namespace
{
Material readGlass(const JsonCursor& node, const JsonCursor& glass)
{
  node.checkKeys({"glass"});
  glass.checkKeys({"transmittance", "refractive_index"});
  Material material;
  material.transmittance = glass.at("transmittance").numberAbove(0.0);
  if (const auto index = glass.find("refractive_index"))
  {
    material.refractiveIndex = index->number();
  }
  const std::string problem = checkMaterial(material);
  if (!problem.empty())
  {
    glass.fail(problem);
  }
  return material;
}

Material readMaterial(const JsonCursor& node)
{
  if (const auto glass = node.find("glass"))
  {
    return readGlass(node, *glass);
  }
  node.checkKeys({"reflectance", "specular", "roughness", "mirror", "exitance"});
  Material material;
  material.reflectance = node.at("reflectance").bands(1.0);
  if (const auto specular = node.find("specular"))
  {
    material.specular = specular->fraction();
  }
  if (const auto roughness = node.find("roughness"))
  {
    material.roughness = roughness->number();
    if (!(material.roughness > 0.0 && material.roughness <= 1.0))
    {
      roughness->failExpected("a number above 0 and at most 1 (a perfect mirror is \"mirror\")");
    }
  }
  if (const auto mirror = node.find("mirror"))
  {
    material.mirror = mirror->fraction();
  }
  if (const auto exitance = node.find("exitance"))
  {
    material.exitance = exitance->bands();
  }
  if (material.specular > 0.0 && !node.has("roughness"))
  {
    node.fail("\"specular\" without \"roughness\"; expected both");
  }
  const std::string problem = checkMaterial(material);
  if (!problem.empty())
  {
    node.fail(problem);
  }
  return material;
}
}  // namespace

Materials readMaterials(const JsonCursor& scene)
{
  Materials materials;
  Material hole;  // marks where light enters, and does nothing to it
  hole.transmittance = hole.refractiveIndex = 1.0;
  materials["opening"] = hole;
  if (const auto section = scene.find("materials"))
  {
    for (const auto& [name, node] : section->members())
    {
      materials[name] = readMaterial(node);
    }
  }
  return materials;
}
}  // namespace kalos::scene
