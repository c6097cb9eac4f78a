// SPDX-License-Identifier: BSD-3-Clause
#include "SceneMaterials.h"

namespace kalos::scene
{
namespace
{
Material ReadMaterial(const JsonCursor& node)
{
  node.CheckKeys({"reflectance", "specular", "roughness", "mirror", "exitance"});
  Material material;
  material.Reflectance = node.At("reflectance").Bands(1.0);
  if (const auto specular = node.Find("specular"))
  {
    material.Specular = specular->Fraction();
  }
  if (const auto roughness = node.Find("roughness"))
  {
    material.Roughness = roughness->Number();
    if (!(material.Roughness > 0.0 && material.Roughness <= 1.0))
    {
      roughness->FailExpected("a number above 0 and at most 1 (a perfect mirror is \"mirror\")");
    }
  }
  if (const auto mirror = node.Find("mirror"))
  {
    material.Mirror = mirror->Fraction();
  }
  if (const auto exitance = node.Find("exitance"))
  {
    material.Exitance = exitance->Bands();
  }
  if (material.Specular > 0.0 && !node.Has("roughness"))
  {
    node.Fail("\"specular\" without \"roughness\"; expected both");
  }
  const std::string problem = CheckMaterial(material);
  if (!problem.empty())
  {
    node.Fail(problem);
  }
  return material;
}
}  // namespace

Materials ReadMaterials(const JsonCursor& scene)
{
  Materials materials;
  if (const auto section = scene.Find("materials"))
  {
    for (const auto& [name, node] : section->Members())
    {
      materials[name] = ReadMaterial(node);
    }
  }
  return materials;
}
}  // namespace kalos::scene
