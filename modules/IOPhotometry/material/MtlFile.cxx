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
  std::string name;
  Color kd{0.8, 0.8, 0.8};
  Color ks{};
  Color ke{};
  double ns = 0.0;
  double opacity = 1.0;
  int illum = 2;
  std::optional<double> metallic;
  std::optional<double> roughness;
  std::string texture;
};

class MtlParser
{
public:
  MtlParser(const std::string& path, Notes& notes) : Path(path), AllNotes(notes), Found(notes) {}

  Materials parse()
  {
    std::ifstream file(this->Path, std::ios::binary);
    std::string line;
    while (std::getline(file, line))
    {
      ++this->LineNumber;
      this->parseLine(line.substr(0, line.find_first_of("#\r")));
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw InputError(this->Path, "line " + std::to_string(this->LineNumber), what);
  }

  void parseLine(const std::string& line)
  {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    std::string keyword;
    words >> keyword;
    if (keyword == "newmtl")
    {
      this->finish();
      this->Current.emplace();
      this->Current->name = rest(words);
      if (this->Current->name.empty())
      {
        this->fail("newmtl without a name; expected the name of a material");
      }
    }
    else if (this->Current)
    {
      this->parseStatement(keyword, words);
    }
  }

  void parseStatement(const std::string& keyword, std::istringstream& words)
  {
    Entry& entry = *this->Current;
    constexpr double any = std::numeric_limits<double>::max();
    if (keyword == "Kd")
      entry.kd = this->readColor(words, 1.0);
    else if (keyword == "Ks")
      entry.ks = this->readColor(words, 1.0);
    else if (keyword == "Ke")
      entry.ke = this->readColor(words, any);
    else if (keyword == "Ns")
      entry.ns = this->readNumber(words, any);
    else if (keyword == "d")
      entry.opacity = this->readNumber(words, 1.0);
    else if (keyword == "Tr")
      entry.opacity = 1.0 - this->readNumber(words, 1.0);
    else if (keyword == "Pm")
      entry.metallic = this->readNumber(words, 1.0);
    else if (keyword == "Pr")
      entry.roughness = this->readNumber(words, 1.0);
    else if (keyword == "illum")
      entry.illum = static_cast<int>(this->readNumber(words, 10.0));
    else if (keyword == "map_Kd")
      entry.texture = rest(words);
  }

  static std::string rest(std::istringstream& words)
  {
    std::string rest;
    std::getline(words >> std::ws, rest);
    rest.erase(rest.find_last_not_of(" \t") + 1);
    return rest;
  }

  double readNumber(std::istringstream& words, double highest)
  {
    double number = 0.0;
    if (!(words >> number) || !(number >= 0.0 && number <= highest))
    {
      this->fail("no number, or one that is out of range; expected at least 0" +
                 (highest < 100.0 ? " and at most " + std::to_string(static_cast<int>(highest)) : std::string()));
    }
    return number;
  }

  /** Three numbers, or one for all. */
  Color readColor(std::istringstream& words, double highest)
  {
    Color color{};
    color.fill(this->readNumber(words, highest));
    if (!(words >> std::ws).eof())
    {
      color[1] = this->readNumber(words, highest);
      color[2] = this->readNumber(words, highest);
    }
    return color;
  }

  void finish()
  {
    if (!this->Current)
    {
      return;
    }
    Entry& entry = *this->Current;
    this->multiplyByTexture(entry);
    Material material;
    MaterialChanges changes;
    if (entry.metallic || entry.roughness)
    {
      material =
          convertMaterial({entry.kd, entry.metallic.value_or(0.0), entry.roughness.value_or(1.0), entry.ke}, changes);
    }
    else
    {
      material = this->convertPhong(entry, changes);
    }
    if (changes.limited)
    {
      this->Found.count("reflectances", entry.name, "scaled to a sum of 0.95",
                        "diffuse and specular reflectance together exceed what any surface reflects");
    }
    if (luminanceOf(entry.ke) > 0.0)
    {
      this->Found.count("emissive materials", entry.name, "exitance pi Ke", "Ke is taken as a luminance in cd/m2");
    }
    if (entry.opacity < 1.0)
    {
      this->Found.count("transparent materials", entry.name, "opaque", "nothing is modelled that passes light");
    }
    this->Result[entry.name] = material;
    this->Current.reset();
  }

  Material convertPhong(const Entry& entry, MaterialChanges& changes)
  {
    Material material;
    Color exitance = entry.ke;
    for (double& m : exitance)
    {
      m *= 3.14159265358979323846;
    }
    material.reflectance = bandsOf(entry.kd);
    material.exitance = bandsOf(exitance);
    const bool reflects = entry.illum == 3 || entry.illum == 5 || entry.illum == 7 || entry.illum == 8;
    if (reflects)
    {
      material.specular = luminanceOf(entry.ks);
      material.roughness = std::max(0.02, std::pow(2.0 / (entry.ns + 2.0), 0.25));
    }
    else if (luminanceOf(entry.ks) > 0.0)
    {
      this->Found.count("highlights", entry.name, "left out", "Ks counts where illum is 3, 5, 7 or 8");
    }
    changes.limited = limitReflectance(material);
    return material;
  }

  void multiplyByTexture(Entry& entry)
  {
    if (entry.texture.empty())
    {
      return;
    }
    // Options may stand before the name.
    const std::string name =
        entry.texture[0] == '-' ? entry.texture.substr(entry.texture.rfind(' ') + 1) : entry.texture;
    const std::string path =
        resolvePath(std::filesystem::path(this->Path).parent_path().string(), name, this->AllNotes);
    std::error_code ignored;
    std::string content, problem = "there is no file " + name;
    if (std::filesystem::is_regular_file(path, ignored))
    {
      std::ifstream file(path, std::ios::binary);
      content.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    const auto* data = reinterpret_cast<const unsigned char*>(content.data());
    const auto mean = content.empty() ? std::nullopt : readAverageColor(data, content.size(), problem);
    if (!mean)
    {
      this->Found.count("textures that can not be read", entry.name, "left out", "Kd alone counts; " + problem);
      return;
    }
    for (int c = 0; c < 3; ++c)
    {
      entry.kd[c] *= mean->linear[c];
    }
    this->Found.count("textures", entry.name, "their mean colour", "a surface has one reflectance all over");
  }

  const std::string& Path;
  Notes& AllNotes;
  NoteCounter Found;
  std::optional<Entry> Current;
  Materials Result;
  long long LineNumber = 0;
};
}  // namespace

Materials readMtlFile(const std::string& path, Notes& notes)
{
  return MtlParser(path, notes).parse();
}
}  // namespace kalos::scene
