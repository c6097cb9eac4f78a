// SPDX-License-Identifier: BSD-3-Clause
#include "StlFile.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "../base/InputError.h"

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

/** Little-endian, as the format is. */
std::uint32_t integer(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

double Float(const char* bytes)
{
  const std::uint32_t bits = integer(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

Mesh parseBinary(const std::string& content)
{
  Mesh mesh;
  for (std::size_t at = HeaderBytes; at + FacetBytes <= content.size(); at += FacetBytes)
  {
    Vector3 corners[3];
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < 3; ++k)
      {
        corners[c][k] = Float(content.data() + at + 12 + 12 * c + 4 * k);
      }
    }
    addFacet(mesh, corners);
  }
  return mesh;
}

/** facet ... vertex X Y Z, three times ... endfacet; several solids in a row are one mesh. */
Mesh parseText(const std::string& content, const std::string& path)
{
  Mesh mesh;
  std::istringstream lines(content);
  std::string line;
  Vector3 corners[3];
  int count = 0;
  bool complete = false;
  for (long long number = 1; std::getline(lines, line); ++number)
  {
    const auto fail = [&](const std::string& what) { throw InputError(path, "line " + std::to_string(number), what); };
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "vertex")
    {
      if (count == 3)
      {
        fail("a facet with more than three corners; expected three");
      }
      Vector3& corner = corners[count++];
      if (!(words >> corner[0] >> corner[1] >> corner[2]))
      {
        fail("a vertex without three numbers; expected vertex X Y Z");
      }
    }
    else if (keyword == "endfacet")
    {
      if (count != 3)
      {
        fail("a facet with " + std::to_string(count) + " corners; expected three");
      }
      addFacet(mesh, corners);
      count = 0;
    }
    else if (keyword == "solid" || keyword == "endsolid")
    {
      complete = keyword == "endsolid";
    }
    else if (!keyword.empty() && keyword != "facet" && keyword != "outer" && keyword != "endloop")
    {
      fail("unknown statement '" + quotable(keyword) + "'; expected facet, vertex or another of an STL file");
    }
  }
  if (!complete)
  {
    throw InputError(path, "file",
                     "no STL file, or the end is missing; expected solid ... endsolid, or a binary STL file");
  }
  return mesh;
}
}  // namespace

Mesh readStlFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // Binary files may start with "solid" too: the size tells them apart.
  const bool text = content.compare(0, 5, "solid") == 0;
  const bool hasCount = content.size() >= HeaderBytes;
  const std::size_t expected = hasCount ? HeaderBytes + FacetBytes * std::size_t{integer(&content[80])} : 0;
  if (hasCount && content.size() == expected)
  {
    return parseBinary(content);
  }
  if (!text)
  {
    throw InputError(path, "file",
                     "no STL file, or damaged: " + std::to_string(content.size()) + " bytes; expected " +
                         (hasCount ? std::to_string(expected) : "at least " + std::to_string(HeaderBytes)) +
                         ", or text from solid to endsolid");
  }
  return parseText(content, path);
}
}  // namespace kalos::scene
