// SPDX-License-Identifier: BSD-3-Clause
#include "MtlFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

#include "../base/FilePaths.h"
#include "../base/InputError.h"
#include "../base/NoteCounter.h"
#include "AverageColor.h"
#include "MetallicRoughness.h"

namespace kalos::scene
{
namespace
{
using Color = std::array<double, 3>;

/** The statements of one newmtl. */
struct Entry
{
  std::string Name;
  Color Kd{0.8, 0.8, 0.8};
  Color Ks{};
  Color Ke{};
  double Ns = 0.0;
  double Opacity = 1.0;
  int Illum = 2;
  std::optional<double> Metallic;
  std::optional<double> Roughness;
  std::string Texture;
};

class MtlParser
{
public:
  MtlParser(const std::string& path, Notes& notes) : Path(path), AllNotes(notes), Found(notes) {}

  Materials Parse()
  {
    std::ifstream file(this->Path, std::ios::binary);
    std::string line;
    while (std::getline(file, line))
    {
      ++this->LineNumber;
      this->ParseLine(line.substr(0, line.find_first_of("#\r")));
    }
    this->Finish();
    return std::move(this->Result);
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw InputError(this->Path, "line " + std::to_string(this->LineNumber), what);
  }

  void ParseLine(const std::string& line)
  {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::string keyword;
    words >> keyword;
    if (keyword == "newmtl")
    {
      this->Finish();
      this->Current.emplace();
      this->Current->Name = Rest(words);
      if (this->Current->Name.empty())
      {
        this->Fail("newmtl without a name; expected the name of a material");
      }
    }
    else if (this->Current)
    {
      this->ParseStatement(keyword, words);
    }
  }

  void ParseStatement(const std::string& keyword, std::istringstream& words)
  {
    Entry& entry = *this->Current;
    constexpr double any = std::numeric_limits<double>::max();
    if (keyword == "Kd")
      entry.Kd = this->ReadColor(words, 1.0);
    else if (keyword == "Ks")
      entry.Ks = this->ReadColor(words, 1.0);
    else if (keyword == "Ke")
      entry.Ke = this->ReadColor(words, any);
    else if (keyword == "Ns")
      entry.Ns = this->ReadNumber(words, any);
    else if (keyword == "d")
      entry.Opacity = this->ReadNumber(words, 1.0);
    else if (keyword == "Tr")
      entry.Opacity = 1.0 - this->ReadNumber(words, 1.0);
    else if (keyword == "Pm")
      entry.Metallic = this->ReadNumber(words, 1.0);
    else if (keyword == "Pr")
      entry.Roughness = this->ReadNumber(words, 1.0);
    else if (keyword == "illum")
      entry.Illum = static_cast<int>(this->ReadNumber(words, 10.0));
    else if (keyword == "map_Kd")
      entry.Texture = Rest(words);
  }

  static std::string Rest(std::istringstream& words)
  {
    std::string rest;
    std::getline(words >> std::ws, rest);
    rest.erase(rest.find_last_not_of(" \t") + 1);
    return rest;
  }

  double ReadNumber(std::istringstream& words, double highest)
  {
    double number = 0.0;
    if (!(words >> number) || !(number >= 0.0 && number <= highest))
    {
      this->Fail("no number, or one that is out of range; expected at least 0" +
                 (highest < 100.0 ? " and at most " + std::to_string(static_cast<int>(highest)) : std::string()));
    }
    return number;
  }

  /** Three numbers, or one for all. */
  Color ReadColor(std::istringstream& words, double highest)
  {
    Color color{};
    color.fill(this->ReadNumber(words, highest));
    if (!(words >> std::ws).eof())
    {
      color[1] = this->ReadNumber(words, highest);
      color[2] = this->ReadNumber(words, highest);
    }
    return color;
  }

  void Finish()
  {
    if (!this->Current)
    {
      return;
    }
    Entry& entry = *this->Current;
    this->MultiplyByTexture(entry);
    Material material;
    MaterialChanges changes;
    if (entry.Metallic || entry.Roughness)
    {
      material =
          ConvertMaterial({entry.Kd, entry.Metallic.value_or(0.0), entry.Roughness.value_or(1.0), entry.Ke}, changes);
    }
    else
    {
      material = this->ConvertPhong(entry, changes);
    }
    if (changes.Limited)
    {
      this->Found.Count("reflectances", entry.Name, "scaled to a sum of 0.95",
                        "diffuse and specular reflectance together exceed what any surface reflects");
    }
    if (LuminanceOf(entry.Ke) > 0.0)
    {
      this->Found.Count("emissive materials", entry.Name, "exitance pi Ke", "Ke is taken as a luminance in cd/m2");
    }
    if (entry.Opacity < 1.0)
    {
      this->Found.Count("transparent materials", entry.Name, "opaque", "nothing is modelled that passes light");
    }
    this->Result[entry.Name] = material;
    this->Current.reset();
  }

  Material ConvertPhong(const Entry& entry, MaterialChanges& changes)
  {
    Material material;
    Color exitance = entry.Ke;
    for (double& m : exitance)
    {
      m *= 3.14159265358979323846;
    }
    material.Reflectance = BandsOf(entry.Kd);
    material.Exitance = BandsOf(exitance);
    const bool reflects = entry.Illum == 3 || entry.Illum == 5 || entry.Illum == 7 || entry.Illum == 8;
    if (reflects)
    {
      material.Specular = LuminanceOf(entry.Ks);
      material.Roughness = std::max(0.02, std::pow(2.0 / (entry.Ns + 2.0), 0.25));
    }
    else if (LuminanceOf(entry.Ks) > 0.0)
    {
      this->Found.Count("highlights", entry.Name, "left out", "Ks counts where illum is 3, 5, 7 or 8");
    }
    changes.Limited = LimitReflectance(material);
    return material;
  }

  void MultiplyByTexture(Entry& entry)
  {
    if (entry.Texture.empty())
    {
      return;
    }
    // Options may stand before the name.
    const std::string name =
        entry.Texture[0] == '-' ? entry.Texture.substr(entry.Texture.rfind(' ') + 1) : entry.Texture;
    const std::string path =
        ResolvePath(std::filesystem::path(this->Path).parent_path().string(), name, this->AllNotes);
    std::error_code ignored;
    std::string content, problem = "there is no file " + name;
    if (std::filesystem::is_regular_file(path, ignored))
    {
      std::ifstream file(path, std::ios::binary);
      content.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    const auto* data = reinterpret_cast<const unsigned char*>(content.data());
    const auto mean = content.empty() ? std::nullopt : ReadAverageColor(data, content.size(), problem);
    if (!mean)
    {
      this->Found.Count("textures that can not be read", entry.Name, "left out", "Kd alone counts; " + problem);
      return;
    }
    for (int c = 0; c < 3; ++c)
    {
      entry.Kd[c] *= mean->Linear[c];
    }
    this->Found.Count("textures", entry.Name, "their mean colour", "a surface has one reflectance all over");
  }

  const std::string& Path;
  Notes& AllNotes;
  NoteCounter Found;
  std::optional<Entry> Current;
  Materials Result;
  long long LineNumber = 0;
};
}  // namespace

Materials ReadMtlFile(const std::string& path, Notes& notes)
{
  return MtlParser(path, notes).Parse();
}
}  // namespace kalos::scene
