// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include <algorithm>
#include <fstream>
#include <locale>
#include <sstream>

#include "SceneError.h"

namespace kalos::scene
{
namespace
{
/** One file while it is read, with the line for messages. */
class ObjParser
{
public:
  ObjParser(const std::string& path, std::vector<std::string>& names) : Path(path), Names(names) {}

  Mesh Parse()
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
      this->ParseLine(continued + line);
      continued.clear();
    }
    return std::move(this->Result);
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw SceneError(this->Path, "line " + std::to_string(this->LineNumber), what);
  }

  void ParseLine(const std::string& line)
  {
    std::istringstream words(line.substr(0, line.find('#')));
    words.imbue(std::locale::classic());
    std::string keyword;
    if (!(words >> keyword))
    {
      return;
    }
    static const char* const ignored[] = {"vt", "vn", "vp", "g", "o", "s", "mtllib", "l", "p"};
    if (keyword == "v")
    {
      Vector3 point;
      if (!(words >> point[0] >> point[1] >> point[2]))
      {
        this->Fail("a vertex without three numbers; expected v X Y Z");
      }
      this->Result.Points.push_back(point);
    }
    else if (keyword == "f")
    {
      this->ParseFace(words);
    }
    else if (keyword == "usemtl")
    {
      this->UseMaterial(words);
    }
    else if (std::find(std::begin(ignored), std::end(ignored), keyword) == std::end(ignored))
    {
      this->Fail("unknown statement '" + Quotable(keyword) + "'; expected v, f, usemtl or another of a polygon mesh");
    }
  }

  void ParseFace(std::istringstream& words)
  {
    std::vector<std::int64_t> corners;
    std::string word;
    while (words >> word)
    {
      const std::string digits = word.substr(0, word.find('/'));
      const auto count = static_cast<std::int64_t>(this->Result.Points.size());
      std::int64_t index = 0;
      std::istringstream number(digits);
      number.imbue(std::locale::classic());
      if (!(number >> index) || number.peek() != std::istringstream::traits_type::eof() || index == 0 ||
          index > count || index < -count)
      {
        this->Fail("a face corner '" + Quotable(digits) + "'; expected a vertex number from 1 to " +
                   std::to_string(count));
      }
      corners.push_back(index > 0 ? index - 1 : count + index);
    }
    if (corners.size() < 3)
    {
      this->Fail("a face with " + std::to_string(corners.size()) + " corners; expected at least 3");
    }
    this->Result.AddPolygon(corners, this->Material);
  }

  void UseMaterial(std::istringstream& words)
  {
    std::string name;
    std::getline(words >> std::ws, name);
    name.erase(name.find_last_not_of(" \t") + 1);
    if (name.empty())
    {
      this->Fail("usemtl without a name; expected the name of a material");
    }
    const auto found = std::find(this->Names.begin(), this->Names.end(), name);
    this->Material = static_cast<std::int32_t>(found - this->Names.begin());
    if (found == this->Names.end())
    {
      this->Names.push_back(name);
    }
  }

  const std::string& Path;
  std::vector<std::string>& Names;
  Mesh Result;
  std::int32_t Material = -1;
  long long LineNumber = 0;
};
}  // namespace

Mesh ReadObjFile(const std::string& path, std::vector<std::string>& materialNames)
{
  return ObjParser(path, materialNames).Parse();
}
}  // namespace kalos::scene
