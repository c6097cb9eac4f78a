// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMaterials.h"

#include <map>
#include <set>

#include "../base/InputError.h"
#include "../base/NoteCounter.h"
#include "../material/AverageColor.h"
#include "../material/MetallicRoughness.h"

namespace kalos::scene
{
namespace
{
std::array<double, 3> color(const JsonCursor& holder, const char* key, double absent, double highest)
{
  std::array<double, 3> color{absent, absent, absent};
  if (const auto node = holder.find(key))
  {
    const std::vector<double> numbers = node->bands();
    if (numbers.size() < 3 || numbers.size() > 4)
    {
      node->failExpected("three or four numbers");
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] = numbers[c];
      if (!(color[c] <= highest))
      {
        node->failExpected("numbers from 0 to 1");
      }
    }
  }
  return color;
}

double factor(const JsonCursor& holder, const char* key, double absent, double highest = 1.0)
{
  const auto node = holder.find(key);
  const double number = node ? node->numberAtLeast(0.0) : absent;
  if (node && !(number <= highest))
  {
    node->failExpected("a number from 0 to 1");
  }
  return number;
}

/** What a thin pane lets through: of KHR_materials_transmission, else what alpha leaves. */
double transmittance(const JsonCursor& node, const MetallicRoughness& source)
{
  const auto extensions = node.find("extensions");
  const auto transmission = extensions ? extensions->find("KHR_materials_transmission") : std::nullopt;
  if (transmission)
  {
    return factor(*transmission, "transmissionFactor", 0.0) * luminanceOf(source.baseColor);
  }
  const auto alpha = node.find("alphaMode"), pbr = node.find("pbrMetallicRoughness");
  const auto base = pbr ? pbr->find("baseColorFactor") : std::nullopt;
  if (!alpha || alpha->string() != "BLEND" || !base || base->items().size() != 4)
  {
    return 0.0;
  }
  return std::clamp(1.0 - base->items()[3].number(), 0.0, 1.0);
}

/** Reads the materials of one file; images are decoded once. */
class Reader
{
public:
  Reader(const GltfFile& file, Notes& notes) : File(file), Found(notes) {}

  GltfMaterial read(const JsonCursor& node)
  {
    const std::string name = node.find("name") ? node.at("name").string() : node.where();
    MetallicRoughness source;
    const auto extensions = node.find("extensions");
    const auto glossy = extensions ? extensions->find("KHR_materials_pbrSpecularGlossiness") : std::nullopt;
    const auto pbr = node.find("pbrMetallicRoughness");
    if (glossy)
    {
      this->readGlossiness(*glossy, name, source);
    }
    else if (pbr)
    {
      this->readMetallic(*pbr, name, source);
    }
    this->readEmission(node, name, source);
    MaterialChanges changes;
    GltfMaterial result{convertMaterial(source, changes), source};
    const auto sides = node.find("doubleSided");
    result.emitsOnBothSides = sides && sides->boolean() && luminanceOf(source.luminance) > 0.0;
    this->tellEmission(name, source, result.emitsOnBothSides);
    this->tell(node, name, changes);
    if (const double through = transmittance(node, source); through > 0.0)
    {
      result = GltfMaterial{};
      result.material.transmittance = std::min(through, clearestGlass(PlainGlass));
      this->Found.count("transparent materials", name, "thin panes of glass",
                        "each face is one, of refractive index 1.52; transmission, or 1 - alpha, is its transmittance");
    }
    return result;
  }

private:
  static void multiply(std::array<double, 3>& color, const std::array<double, 3>& by)
  {
    for (int c = 0; c < 3; ++c)
    {
      color[c] *= by[c];
    }
  }

  void readMetallic(const JsonCursor& pbr, const std::string& name, MetallicRoughness& source)
  {
    source.baseColor = color(pbr, "baseColorFactor", 1.0, 1.0);
    source.metallic = factor(pbr, "metallicFactor", 1.0);
    source.roughness = factor(pbr, "roughnessFactor", 1.0);
    if (const auto mean = this->average(pbr, "baseColorTexture", name))
    {
      multiply(source.baseColor, mean->linear);
    }
    if (const auto mean = this->average(pbr, "metallicRoughnessTexture", name))
    {
      source.roughness *= mean->encoded[1];
      source.metallic *= mean->encoded[2];
    }
  }

  void readGlossiness(const JsonCursor& glossy, const std::string& name, MetallicRoughness& source)
  {
    source.baseColor = color(glossy, "diffuseFactor", 1.0, 1.0);
    source.roughness = 1.0 - factor(glossy, "glossinessFactor", 1.0);
    std::array<double, 3> specular = color(glossy, "specularFactor", 1.0, 1.0);
    if (const auto mean = this->average(glossy, "diffuseTexture", name))
    {
      multiply(source.baseColor, mean->linear);
    }
    if (const auto mean = this->average(glossy, "specularGlossinessTexture", name))
    {
      multiply(specular, mean->linear);
    }
    source.specular = luminanceOf(specular);
  }

  void readEmission(const JsonCursor& node, const std::string& name, MetallicRoughness& source)
  {
    source.luminance = color(node, "emissiveFactor", 0.0, 1.0);
    const auto extensions = node.find("extensions");
    const auto strength = extensions ? extensions->find("KHR_materials_emissive_strength") : std::nullopt;
    const double scale = strength ? factor(*strength, "emissiveStrength", 1.0, 1e12) : 1.0;
    multiply(source.luminance, {scale, scale, scale});
    if (const auto mean = this->average(node, "emissiveTexture", name))
    {
      multiply(source.luminance, mean->linear);
    }
  }

  void tellEmission(const std::string& name, const MetallicRoughness& source, bool bothSides)
  {
    if (luminanceOf(source.luminance) > 0.0)
    {
      this->Found.count("emissive materials", name, "exitance pi L",
                        std::string("glTF gives their luminance in cd/m2; they emit by Lambert's law ") +
                            (bothSides ? "on both sides" : "on the side of the normal"));
    }
  }

  void tell(const JsonCursor& node, const std::string& name, const MaterialChanges& changes)
  {
    if (changes.limited)
    {
      this->Found.count("reflectances", name, "scaled to a sum of 0.95",
                        "diffuse and specular reflectance together exceed what any surface reflects");
    }
    if (changes.neutralMetal)
    {
      this->Found.count("coloured metals", name, "neutral", "a glossy lobe has no colour here: its luminance is right");
    }
    if (changes.roughDielectric)
    {
      this->Found.count("rough dielectrics", name, "Lambertian",
                        "from roughness 0.5 on, the 4 % that their surface reflects count as part of the base colour");
    }
    const auto alpha = node.find("alphaMode");
    const auto extensions = node.find("extensions");
    if (extensions && extensions->has("KHR_materials_diffuse_transmission"))
    {
      this->Found.count("translucent materials", name, "opaque", "no surface passes light diffusely");
    }
    if (alpha && alpha->string() == "MASK")
    {
      this->Found.count("masked materials", name, "opaque", "a surface has no holes by texture");
    }
  }

  /** The mean colour of a texture, if there is one that can be read. */
  const AverageColor* average(const JsonCursor& holder, const char* key, const std::string& material)
  {
    const auto info = holder.find(key);
    if (!info)
    {
      return nullptr;
    }
    const JsonCursor& texture = this->File.element(info->at("index"), "textures");
    std::string problem = "it has no image in PNG or JPEG";
    if (const auto source = texture.find("source"))
    {
      const std::size_t image = this->File.index(*source, "images");
      auto found = this->Images.find(image);
      if (found == this->Images.end())
      {
        found = this->Images.emplace(image, this->decode(this->File.section("images")[image], problem)).first;
      }
      if (found->second)
      {
        this->Found.count("textures", material, "their mean colour", "a surface has one reflectance all over");
        return &*found->second;
      }
    }
    this->Found.count("textures that cannot be read", material, "left out", "the factor alone counts; " + problem);
    return nullptr;
  }

  /** Empty for a missing image as well; `problem` says why. */
  std::optional<AverageColor> decode(const JsonCursor& image, std::string& problem) const
  {
    try
    {
      const Bytes bytes = this->File.image(image);
      return readAverageColor(bytes.data, bytes.size, problem);
    }
    catch (const InputError& error)
    {
      problem = error.what();
      return {};
    }
  }

  const GltfFile& File;
  NoteCounter Found;
  std::map<std::size_t, std::optional<AverageColor>> Images;
};
}  // namespace

Material multiplyBaseColor(const GltfMaterial& material, const std::array<double, 3>& color)
{
  if (!material.source)
  {
    return material.material;
  }
  MetallicRoughness source = *material.source;
  for (int c = 0; c < 3; ++c)
  {
    source.baseColor[c] *= color[c];
  }
  MaterialChanges ignored;
  return convertMaterial(source, ignored);
}

std::vector<GltfMaterial> readGltfMaterials(const GltfFile& file, const Materials& overrides, Notes& notes)
{
  std::vector<GltfMaterial> materials;
  Reader reader(file, notes);
  for (const JsonCursor& node : file.section("materials"))
  {
    const auto name = node.find("name");
    const auto given = name ? overrides.find(name->string()) : overrides.end();
    materials.push_back(given != overrides.end() ? GltfMaterial{given->second, {}} : reader.read(node));
  }
  return materials;
}
}  // namespace kalos::scene
