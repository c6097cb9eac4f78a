// SPDX-License-Identifier: BSD-3-Clause
#include "MtlFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "../base/FilePaths.h"
#include "../base/NoteCounter.h"
#include "AverageColor.h"
#include "MetallicRoughness.h"
#include "MtlStatements.h"

namespace kalos::scene
{
namespace
{
using Color = std::array<double, 3>;

constexpr double Pi = 3.14159265358979323846;

/** Makes materials of a library's entries. */
class Converter
{
public:
  Converter(const std::string& path, Notes& notes)
      : Folder(std::filesystem::path(path).parent_path().string()), AllNotes(notes), Found(notes)
  {
  }

  Material convert(const MtlEntry& entry)
  {
    const Color diffuse = this->textured(entry, "map_kd", entry.color("kd", 0.8, 1.0));
    const Color luminance = this->textured(entry, "map_ke", entry.color("ke", entry.has("map_ke") ? 1.0 : 0.0));
    MaterialChanges changes;
    const bool physical = entry.has("pm") || entry.has("pr");
    const Material material =
        physical
            ? convertMaterial({diffuse, entry.number("pm", 0.0, 1.0), entry.number("pr", 1.0, 1.0), luminance}, changes)
            : this->convertPhong(entry, diffuse, luminance, changes);
    if (changes.limited)
    {
      this->Found.count("reflectances", entry.name, "scaled to a sum of 0.95",
                        "diffuse and specular reflectance together exceed what any surface reflects");
    }
    if (luminanceOf(luminance) > 0.0)
    {
      this->Found.count("emissive materials", entry.name, "exitance pi Ke", "Ke is taken as a luminance in cd/m2");
    }
    this->tellWhatIsLeftOut(entry);
    return this->transparent(entry, material);
  }

private:
  Material convertPhong(const MtlEntry& entry, const Color& diffuse, Color exitance, MaterialChanges& changes)
  {
    Material material;
    for (double& m : exitance)
    {
      m *= Pi;
    }
    material.reflectance = bandsOf(diffuse);
    material.exitance = bandsOf(exitance);
    const double illum = entry.has("illum") ? entry.number("illum", 2.0) : 2.0;
    if (illum == 3.0 || illum == 5.0 || illum == 7.0 || illum == 8.0)
    {
      material.specular = luminanceOf(entry.color("ks", 0.0, 1.0));
      material.roughness = std::max(0.02, std::pow(2.0 / (entry.number("ns", 0.0) + 2.0), 0.25));
    }
    else if (entry.has("ks"))
    {
      this->Found.count("highlights", entry.name, "left out", "Ks counts where illum is 3, 5, 7 or 8");
    }
    changes.limited = limitReflectance(material);
    return material;
  }

  /** A pane of glass where the entry lets light through, times its filter's colour. */
  Material transparent(const MtlEntry& entry, const Material& opaque)
  {
    const double opacity = entry.has("d") ? entry.number("d", 1.0) : 1.0 - entry.number("tr", 0.0);
    const double through = opacity < 1.0 ? (1.0 - opacity) * luminanceOf(entry.color("tf", 1.0, 1.0)) : 0.0;
    if (!(through > 0.0))
    {
      return opaque;
    }
    Material pane;
    pane.transmittance = std::min(through, clearestGlass(PlainGlass));
    this->Found.count("transparent materials", entry.name, "thin panes of glass",
                      "each face is one, of refractive index 1.52; d and Tf are its transmittance");
    return pane;
  }

  void tellWhatIsLeftOut(const MtlEntry& entry)
  {
    if (entry.has("map_d"))
    {
      this->Found.count("transparent materials", entry.name, "opaque", "a surface has no holes by texture");
    }
    for (const char* keyword : {"map_ks", "map_pr", "map_pm", "map_ps", "decal", "pc", "ps"})
    {
      const bool map = keyword[1] != 'c' && keyword[1] != 's';
      if (entry.has(keyword) && (map || entry.number(keyword, 0.0) > 0.0))
      {
        this->Found.count(std::string("statement ") + keyword, entry.name, "left out", "no such property is modelled");
      }
    }
  }

  /** The colour times the mean of a texture, if the entry names one. */
  Color textured(const MtlEntry& entry, const char* keyword, Color color)
  {
    const std::string name = entry.file(keyword);
    if (name.empty())
    {
      return color;
    }
    std::string content, problem = "there is no file " + name;
    if (const auto path = findFile(this->Folder, name, this->AllNotes))
    {
      std::ifstream file(*path, std::ios::binary);
      content.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    const auto* data = reinterpret_cast<const unsigned char*>(content.data());
    const auto mean = content.empty() ? std::nullopt : readAverageColor(data, content.size(), problem);
    if (!mean)
    {
      this->Found.count("textures that cannot be read", entry.name, "left out",
                        std::string(keyword == std::string("map_kd") ? "Kd" : "Ke") + " alone counts; " + problem);
      return color;
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] *= mean->linear[c];
    }
    this->Found.count("textures", entry.name, "their mean colour", "a surface has one reflectance all over");
    return color;
  }

  std::string Folder;
  Notes& AllNotes;
  NoteCounter Found;
};
}  // namespace

Materials readMtlFile(const std::string& path, Notes& notes)
{
  Materials materials;
  Converter converter(path, notes);
  for (const MtlEntry& entry : readMtlStatements(path))
  {
    materials[entry.name] = converter.convert(entry);
  }
  return materials;
}
}  // namespace kalos::scene
