// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMaterials.h"

#include <map>
#include <set>

#include "../base/NoteCounter.h"
#include "../material/AverageColor.h"
#include "../material/MetallicRoughness.h"

namespace kalos::scene
{
namespace
{
std::array<double, 3> Color(const JsonCursor& holder, const char* key, double absent, double highest)
{
  std::array<double, 3> color{absent, absent, absent};
  if (const auto node = holder.Find(key))
  {
    const std::vector<double> numbers = node->Bands();
    if (numbers.size() < 3 || numbers.size() > 4)
    {
      node->FailExpected("three or four numbers");
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] = numbers[c];
      if (!(color[c] <= highest))
      {
        node->FailExpected("numbers from 0 to 1");
      }
    }
  }
  return color;
}

double Factor(const JsonCursor& holder, const char* key, double absent, double highest = 1.0)
{
  const auto node = holder.Find(key);
  const double number = node ? node->NumberAtLeast(0.0) : absent;
  if (node && !(number <= highest))
  {
    node->FailExpected("a number from 0 to 1");
  }
  return number;
}

/** Reads the materials of one file; images are decoded once. */
class Reader
{
public:
  Reader(const GltfFile& file, Notes& notes) : File(file), Found(notes) {}

  Material Read(const JsonCursor& node)
  {
    const std::string name = node.Find("name") ? node.At("name").String() : node.Where();
    MetallicRoughness source;
    if (const auto pbr = node.Find("pbrMetallicRoughness"))
    {
      source.BaseColor = Color(*pbr, "baseColorFactor", 1.0, 1.0);
      source.Metallic = Factor(*pbr, "metallicFactor", 1.0);
      source.Roughness = Factor(*pbr, "roughnessFactor", 1.0);
      if (const auto mean = this->Average(*pbr, "baseColorTexture", name))
      {
        Multiply(source.BaseColor, mean->Linear);
      }
      if (const auto mean = this->Average(*pbr, "metallicRoughnessTexture", name))
      {
        source.Roughness *= mean->Encoded[1];
        source.Metallic *= mean->Encoded[2];
      }
    }
    this->ReadEmission(node, name, source);
    MaterialChanges changes;
    const Material material = ConvertMaterial(source, changes);
    this->Tell(node, name, changes);
    return material;
  }

private:
  static void Multiply(std::array<double, 3>& color, const std::array<double, 3>& by)
  {
    for (int c = 0; c < 3; ++c)
    {
      color[c] *= by[c];
    }
  }

  void ReadEmission(const JsonCursor& node, const std::string& name, MetallicRoughness& source)
  {
    source.Luminance = Color(node, "emissiveFactor", 0.0, 1.0);
    const auto extensions = node.Find("extensions");
    const auto strength = extensions ? extensions->Find("KHR_materials_emissive_strength") : std::nullopt;
    const double scale = strength ? Factor(*strength, "emissiveStrength", 1.0, 1e12) : 1.0;
    Multiply(source.Luminance, {scale, scale, scale});
    if (const auto mean = this->Average(node, "emissiveTexture", name))
    {
      Multiply(source.Luminance, mean->Linear);
    }
    if (LuminanceOf(source.Luminance) > 0.0)
    {
      this->Found.Count("emissive materials", name, "exitance pi L",
                        "glTF gives their luminance in cd/m2; they emit by Lambert's law on the side of the normal");
    }
  }

  void Tell(const JsonCursor& node, const std::string& name, const MaterialChanges& changes)
  {
    if (changes.Limited)
    {
      this->Found.Count("reflectances", name, "scaled to a sum of 0.95",
                        "diffuse and specular reflectance together exceed what any surface reflects");
    }
    if (changes.NeutralMetal)
    {
      this->Found.Count("coloured metals", name, "neutral", "a glossy lobe has no colour here: its luminance is right");
    }
    if (changes.RoughDielectric)
    {
      this->Found.Count("rough dielectrics", name, "Lambertian",
                        "from roughness 0.5 on, the 4 % that their surface reflects count as part of the base colour");
    }
    const auto alpha = node.Find("alphaMode");
    const auto extensions = node.Find("extensions");
    const bool transparent = extensions && (extensions->Has("KHR_materials_transmission") ||
                                            extensions->Has("KHR_materials_diffuse_transmission"));
    if (transparent || (alpha && alpha->String() != "OPAQUE"))
    {
      this->Found.Count("transparent materials", name, "opaque", "nothing is modelled that passes light");
    }
  }

  /** The mean colour of a texture, if there is one that can be read. */
  const AverageColor* Average(const JsonCursor& holder, const char* key, const std::string& material)
  {
    const auto info = holder.Find(key);
    if (!info)
    {
      return nullptr;
    }
    const JsonCursor& texture = this->File.Element(info->At("index"), "textures");
    std::string problem = "it has no image in PNG or JPEG";
    if (const auto source = texture.Find("source"))
    {
      const std::size_t image = this->File.Index(*source, "images");
      auto found = this->Images.find(image);
      if (found == this->Images.end())
      {
        const Bytes bytes = this->File.Image(this->File.Section("images")[image]);
        found = this->Images.emplace(image, ReadAverageColor(bytes.Data, bytes.Size, problem)).first;
      }
      if (found->second)
      {
        this->Found.Count("textures", material, "their mean colour", "a surface has one reflectance all over");
        return &*found->second;
      }
    }
    this->Found.Count("textures that can not be read", material, "left out", "the factor alone counts; " + problem);
    return nullptr;
  }

  const GltfFile& File;
  NoteCounter Found;
  std::map<std::size_t, std::optional<AverageColor>> Images;
};
}  // namespace

std::vector<Material> ReadGltfMaterials(const GltfFile& file, const Materials& overrides, Notes& notes)
{
  std::vector<Material> materials;
  Reader reader(file, notes);
  for (const JsonCursor& node : file.Section("materials"))
  {
    const auto name = node.Find("name");
    const auto given = name ? overrides.find(name->String()) : overrides.end();
    materials.push_back(given != overrides.end() ? given->second : reader.Read(node));
  }
  return materials;
}
}  // namespace kalos::scene
