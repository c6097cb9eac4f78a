// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include <sstream>

#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
PlyType typeOf(const std::string& name)
{
  static const char* const names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                         {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                         {"float", "float32"}, {"double", "float64"}};
  for (int i = 0; i < 8; ++i)
  {
    if (name == names[i][0] || name == names[i][1])
    {
      return static_cast<PlyType>(i);
    }
  }
  return PlyType::None;
}

class HeaderParser
{
public:
  HeaderParser(std::istream& file, const std::string& path) : File(file), Path(path) {}

  PlyHeader parse()
  {
    std::string line;
    bool first = true;
    while (this->readLine(line))
    {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (first != (keyword == "ply"))
      {
        this->fail("does not start with 'ply'; expected a PLY file");
      }
      first = false;
      if (keyword == "end_header")
      {
        this->check();
        return std::move(this->Result);
      }
      this->parseStatement(keyword, words);
    }
    this->fail("ends within the header; expected end_header");
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(this->Path, "header", what); }

  void parseStatement(const std::string& keyword, std::istringstream& words)
  {
    if (keyword == "format")
    {
      this->HasFormat = true;
      this->parseFormat(words);
    }
    else if (keyword == "element")
    {
      PlyElement element;
      if (!(words >> element.name >> element.size) || element.size < 0)
      {
        this->fail("a damaged element line; expected element NAME COUNT");
      }
      this->Result.elements.push_back(element);
    }
    else if (keyword == "property")
    {
      this->parseProperty(words);
    }
    else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info")
    {
      this->fail("an unknown statement; expected format, element, property, comment or end_header");
    }
  }

  void check() const
  {
    if (!this->HasFormat)
    {
      this->fail("no format; expected ascii, binary_little_endian or binary_big_endian");
    }
    for (const PlyElement& element : this->Result.elements)
    {
      // Items without properties take no bytes, so that any number of them would be read.
      if (element.size > 0 && element.properties.empty())
      {
        this->fail("the element " + quotable(element.name) + " has no properties; expected at least one");
      }
    }
  }

  bool readLine(std::string& line)
  {
    // A binary file without a header must not be read as one endless line.
    line.clear();
    char c = 0;
    while (line.size() < 4096 && this->File.get(c) && c != '\n')
    {
      line += c;
    }
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return c == '\n' && this->File.good();
  }

  void parseFormat(std::istringstream& words)
  {
    std::string format;
    words >> format;
    this->Result.ascii = format == "ascii";
    const bool big = format == "binary_big_endian";
    this->Result.order = big ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    if (!this->Result.ascii && !big && format != "binary_little_endian")
    {
      this->fail("an unknown format; expected ascii, binary_little_endian or binary_big_endian");
    }
  }

  void parseProperty(std::istringstream& words)
  {
    std::string type;
    std::string count;
    PlyProperty property;
    words >> type;
    if (type == "list")
    {
      words >> count >> type;
      property.count = typeOf(count);
    }
    words >> property.name;
    property.item = typeOf(type);
    const bool countIsWhole = count.empty() || property.count < PlyType::Float32;
    if (this->Result.elements.empty() || property.item == PlyType::None || !countIsWhole || property.name.empty())
    {
      this->fail("a damaged property line; expected property TYPE NAME or property list TYPE TYPE NAME");
    }
    this->Result.elements.back().properties.push_back(property);
  }

  std::istream& File;
  const std::string& Path;
  PlyHeader Result;
  bool HasFormat = false;
};
}  // namespace

PlyHeader readPlyHeader(std::istream& file, const std::string& path)
{
  return HeaderParser(file, path).parse();
}
}  // namespace kalos::scene
