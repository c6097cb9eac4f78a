// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include <algorithm>
#include <fstream>
#include <locale>
#include <map>
#include <sstream>

#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
/** One file while it is read, with the line for messages. */
class ObjParser
{
public:
  explicit ObjParser(const std::string& path) : Path(path) { this->Result.objectNames.emplace_back(); }

  ObjFile parse()
  {
    std::ifstream file(this->Path, std::ios::binary);
    std::string line;
    std::string continued;
    while (std::getline(file, line))
    {
      ++this->LineNumber;
      if (!line.empty() && line.back() == '\r')
      {
        line.pop_back();
      }
      if (!line.empty() && line.back() == '\\')
      {
        line.back() = ' ';
        continued += line;
        continue;
      }
      this->parseLine(continued + line);
      continued.clear();
    }
    return std::move(this->Result);
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw InputError(this->Path, "line " + std::to_string(this->LineNumber), what);
  }

  void parseLine(const std::string& line)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    words.imbue(std::locale::classic());
    std::string keyword;
    if (!(words >> keyword))
    {
      return;
    }
    static const char* const ignored[] = {"vt", "vn", "vp", "s", "l", "p"};
    if (keyword == "v")
    {
      Vector3 point;
      if (!(words >> point[0] >> point[1] >> point[2]))
      {
        this->fail("a vertex without three numbers; expected v X Y Z");
      }
      this->Result.polygons.points.push_back(point);
    }
    else if (keyword == "f")
    {
      this->parseFace(words);
    }
    else if (keyword == "usemtl")
    {
      this->useMaterial(words);
    }
    else if (keyword == "mtllib")
    {
      number(this->Result.libraries, this->Libraries, rest(words));
    }
    else if (keyword == "o" || keyword == "g")
    {
      this->beginObject(keyword, rest(words));
    }
    else if (std::find(std::begin(ignored), std::end(ignored), keyword) == std::end(ignored))
    {
      this->fail("unknown statement '" + quotable(keyword) + "'; expected v, f, usemtl or another of a polygon mesh");
    }
  }

  void parseFace(std::istringstream& words)
  {
    std::vector<std::int64_t> corners;
    std::string word;
    while (words >> word)
    {
      const std::string digits = word.substr(0, word.find('/'));
      const auto count = static_cast<std::int64_t>(this->Result.polygons.points.size());
      std::int64_t index = 0;
      std::istringstream number(digits);
      number.imbue(std::locale::classic());
      if (!(number >> index) || number.peek() != std::istringstream::traits_type::eof() || index == 0 ||
          index > count || index < -count)
      {
        this->fail("a face corner '" + quotable(digits) + "'; expected a vertex number from 1 to " +
                   std::to_string(count));
      }
      corners.push_back(index > 0 ? index - 1 : count + index);
    }
    if (corners.size() < 3)
    {
      this->fail("a face with " + std::to_string(corners.size()) + " corners; expected at least 3");
    }
    this->Result.polygons.addPolygon(corners, this->Material);
    this->Result.objectOf.push_back(this->Object);
  }

  static std::string rest(std::istringstream& words)
  {
    std::string rest;
    std::getline(words >> std::ws, rest);
    rest.erase(rest.find_last_not_of(" \t") + 1);
    return rest;
  }

  /** The index of a name in a list, which gets it if it is new. */
  static std::size_t number(std::vector<std::string>& names, std::map<std::string, std::size_t>& known,
                            const std::string& name)
  {
    const auto [found, added] = known.emplace(name, names.size());
    if (added)
    {
      names.push_back(name);
    }
    return found->second;
  }

  void useMaterial(std::istringstream& words)
  {
    const std::string name = rest(words);
    if (name.empty())
    {
      this->fail("usemtl without a name; expected the name of a material");
    }
    this->Material = static_cast<std::int32_t>(number(this->Result.materialNames, this->Materials, name));
  }

  /** Groups divide a file that has no objects. */
  void beginObject(const std::string& keyword, const std::string& name)
  {
    this->HasObjects = this->HasObjects || keyword == "o";
    if (keyword == "o" || !this->HasObjects)
    {
      this->Object = number(this->Result.objectNames, this->Objects, name);
    }
  }

  const std::string& Path;
  ObjFile Result;
  std::map<std::string, std::size_t> Libraries;
  std::map<std::string, std::size_t> Materials;
  std::map<std::string, std::size_t> Objects{{"", 0}};
  std::int32_t Material = -1;
  std::size_t Object = 0;
  bool HasObjects = false;
  long long LineNumber = 0;
};
}  // namespace

ObjFile readObjFile(const std::string& path)
{
  return ObjParser(path).parse();
}
}  // namespace kalos::scene
