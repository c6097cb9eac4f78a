// SPDX-License-Identifier: BSD-3-Clause
#include "StlFile.h"

#include <fstream>
#include <iterator>

#include "../base/ByteOrder.h"
#include "../base/InputError.h"
#include "../base/TextLines.h"

namespace kalos::scene
{
namespace
{
constexpr std::size_t HeaderBytes = 84;  ///< 80 of text and the count
constexpr std::size_t FacetBytes = 50;   ///< normal, three corners, attribute

void addFacet(Mesh& mesh, const Vector3 corners[3])
{
  const auto first = static_cast<std::int64_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners, corners + 3);
  mesh.addPolygon({first, first + 1, first + 2}, -1);
}

Mesh parseBinary(const std::string& content, std::size_t facets)
{
  Mesh mesh;
  for (std::size_t i = 0; i < facets; ++i)
  {
    const char* bytes = content.data() + HeaderBytes + FacetBytes * i + 12;
    Vector3 corners[3];
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < 3; ++k)
      {
        corners[c][k] = fromBytes<float>(bytes + 12 * c + 4 * k);
      }
    }
    addFacet(mesh, corners);
  }
  return mesh;
}

/** facet ... vertex X Y Z, three times ... endfacet; several solids in a row are one mesh. */
class TextParser
{
public:
  TextParser(const std::string& path, Notes& notes) : Path(path), Found(notes), Lines(path) {}

  Mesh parse()
  {
    while (this->Lines.next())
    {
      this->parseLine();
    }
    if (this->Inside && (this->Count != 0 || this->InFacet || this->Result.numberOfPolygons() == 0))
    {
      throw InputError(this->Path, "file",
                       "no STL file, or the end is missing; expected solid ... endsolid, or a binary STL file");
    }
    if (this->Inside)
    {
      this->Found.push_back({"STL", "read up to its last facet", "the word endsolid is missing"});
    }
    return std::move(this->Result);
  }

private:
  void parseLine()
  {
    Words words(this->Lines.text());
    std::string keyword = lowerCase(words.next());
    if (keyword == "end")
    {
      keyword += lowerCase(words.next());
    }
    if (keyword == "vertex")
    {
      this->parseVertex(words);
    }
    else if (keyword == "facet")
    {
      this->InFacet = true;
    }
    else if (keyword == "endfacet")
    {
      if (this->Count != 3)
      {
        this->Lines.fail("a facet with " + std::to_string(this->Count) + " corners; expected three");
      }
      addFacet(this->Result, this->Corners);
      this->Count = 0;
      this->InFacet = false;
    }
    else if (keyword == "solid" || keyword == "endsolid")
    {
      this->Inside = keyword == "solid";
    }
    else if (!keyword.empty() && keyword != "outer" && keyword != "endloop" && keyword != "color")
    {
      this->Lines.fail("unknown statement '" + quotable(keyword) +
                       "'; expected facet, vertex or another of an STL file");
    }
  }

  void parseVertex(Words& words)
  {
    if (this->Count == 3)
    {
      this->Lines.fail("a facet with more than three corners; expected three");
    }
    Vector3& corner = this->Corners[this->Count++];
    if (!words.number(corner[0]) || !words.number(corner[1]) || !words.number(corner[2]))
    {
      this->Lines.fail("a vertex without three numbers; expected vertex X Y Z");
    }
  }

  const std::string& Path;
  Notes& Found;
  TextLines Lines;
  Mesh Result;
  Vector3 Corners[3];
  int Count = 0;
  bool InFacet = false;
  bool Inside = true;
};

/** Whether it begins with "solid", whatever the letters, after blanks and a mark of UTF-8. */
bool beginsAsText(const std::string& content)
{
  std::size_t at = content.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  at = std::min(content.find_first_not_of(" \t\r\n", at), content.size());
  return lowerCase(content.substr(at, 5)) == "solid";
}

/** Whether "facet" follows the first line: binary files may begin with "solid", too. */
bool continuesAsText(const std::string& content)
{
  const std::string start = lowerCase(std::string_view(content).substr(0, 4096));
  const std::size_t solid = start.find("solid");
  return start.find("facet", solid) != start.npos && start.find('\0') == start.npos;
}
}  // namespace

Mesh readStlFile(const std::string& path, Notes& notes)
{
  std::ifstream file(path, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const bool hasCount = content.size() >= HeaderBytes;
  const std::size_t facets = hasCount ? std::size_t{fromBytes<std::uint32_t>(&content[80])} : 0;
  const std::size_t expected = HeaderBytes + FacetBytes * facets;
  const bool text = beginsAsText(content);
  if (hasCount && content.size() >= expected && (content.size() == expected || !text || !continuesAsText(content)))
  {
    if (content.size() > expected)
    {
      notes.push_back({"STL", "read up to its last facet",
                       std::to_string(content.size() - expected) + " bytes follow those that its count tells"});
    }
    return parseBinary(content, facets);
  }
  if (!text)
  {
    throw InputError(path, "file",
                     "no STL file, or damaged: " + std::to_string(content.size()) + " bytes; expected " +
                         (hasCount ? std::to_string(expected) : "at least " + std::to_string(HeaderBytes)) +
                         ", or text from solid to endsolid");
  }
  return TextParser(path, notes).parse();
}
}  // namespace kalos::scene
