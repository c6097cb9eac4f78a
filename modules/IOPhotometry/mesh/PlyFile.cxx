// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
enum class Type
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
  None
};

Type typeOf(const std::string& name)
{
  static const char* const names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                         {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                         {"float", "float32"}, {"double", "float64"}};
  for (int i = 0; i < 8; ++i)
  {
    if (name == names[i][0] || name == names[i][1])
    {
      return static_cast<Type>(i);
    }
  }
  return Type::None;
}

struct Property
{
  std::string name;
  Type item = Type::None;
  Type count = Type::None;  ///< of a list; None for a scalar
};

struct Element
{
  std::string name;
  std::int64_t size = 0;
  std::vector<Property> properties;
};

class PlyParser
{
public:
  explicit PlyParser(const std::string& path) : Path(path), File(path, std::ios::binary) {}

  Mesh parse()
  {
    this->parseHeader();
    for (const Element& element : this->Elements)
    {
      for (std::int64_t i = 0; i < element.size; ++i)
      {
        this->Place = element.name + " " + std::to_string(i + 1);
        this->parseItem(element);
      }
    }
    return std::move(this->Result);
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(this->Path, this->Place, what); }

  void parseHeader()
  {
    std::string line;
    bool first = true;
    bool hasFormat = false;
    while (this->readHeaderLine(line))
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
        if (!hasFormat)
        {
          this->fail("no format; expected ascii, binary_little_endian or binary_big_endian");
        }
        this->checkElements();
        return;
      }
      if (keyword == "format")
      {
        hasFormat = true;
        this->parseFormat(words);
      }
      else if (keyword == "element")
      {
        Element element;
        if (!(words >> element.name >> element.size) || element.size < 0)
        {
          this->fail("a damaged element line; expected element NAME COUNT");
        }
        this->Elements.push_back(element);
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
    this->fail("ends within the header; expected end_header");
  }

  /** Items without properties take no bytes, so that any number of them would be read. */
  void checkElements() const
  {
    for (const Element& element : this->Elements)
    {
      if (element.size > 0 && element.properties.empty())
      {
        this->fail("the element " + quotable(element.name) + " has no properties; expected at least one");
      }
    }
  }

  bool readHeaderLine(std::string& line)
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
    this->Ascii = format == "ascii";
    this->BigEndian = format == "binary_big_endian";
    if (!this->Ascii && !this->BigEndian && format != "binary_little_endian")
    {
      this->fail("an unknown format; expected ascii, binary_little_endian or binary_big_endian");
    }
  }

  void parseProperty(std::istringstream& words)
  {
    std::string type;
    std::string count;
    Property property;
    words >> type;
    if (type == "list")
    {
      words >> count >> type;
      property.count = typeOf(count);
    }
    words >> property.name;
    property.item = typeOf(type);
    const bool countIsWhole = count.empty() || property.count < Type::Float32;
    if (this->Elements.empty() || property.item == Type::None || !countIsWhole || property.name.empty())
    {
      this->fail("a damaged property line; expected property TYPE NAME or property list TYPE TYPE NAME");
    }
    this->Elements.back().properties.push_back(property);
  }

  void parseItem(const Element& element)
  {
    Vector3 point{};
    int coordinates = 0;
    std::vector<std::int64_t> corners;
    bool hasCorners = false;
    for (const Property& property : element.properties)
    {
      const bool list = property.count != Type::None;
      const bool wanted = element.name == "face" && list && property.name.rfind("vertex_ind", 0) == 0;
      const double count = list ? this->readNumber(property.count) : 1.0;
      if (!(count >= 0.0))
      {
        this->fail("a list with a negative count; expected at least 0");
      }
      for (double i = 0.0; i < count; ++i)
      {
        const double value = this->readNumber(property.item);
        if (wanted)
        {
          corners.push_back(this->asIndex(value));
        }
        else if (!list && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
        {
          point[property.name[0] - 'x'] = value;
          ++coordinates;
        }
      }
      hasCorners = hasCorners || wanted;
    }
    if (element.name == "vertex")
    {
      if (coordinates != 3)
      {
        this->fail("vertices without x, y and z; expected all three");
      }
      this->Result.points.push_back(point);
    }
    else if (element.name == "face")
    {
      if (!hasCorners)
      {
        this->fail("faces without the list vertex_indices; expected it");
      }
      this->Result.addPolygon(corners, -1);
    }
  }

  std::int64_t asIndex(double value) const
  {
    // Out of range becomes -1, which the mesh check names; a cast would be undefined.
    return value >= 0.0 && value < 9e15 ? static_cast<std::int64_t>(value) : -1;
  }

  double readNumber(Type type)
  {
    if (this->Ascii)
    {
      std::string word;
      if (!(this->File >> word))
      {
        this->fail("the file ends here; expected more numbers");
      }
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end != '\0')
      {
        this->fail("'" + quotable(word) + "'; expected a number");
      }
      return value;
    }
    switch (type)
    {
      case Type::Int8:
        return this->readBinary<std::int8_t>();
      case Type::UInt8:
        return this->readBinary<std::uint8_t>();
      case Type::Int16:
        return this->readBinary<std::int16_t>();
      case Type::UInt16:
        return this->readBinary<std::uint16_t>();
      case Type::Int32:
        return this->readBinary<std::int32_t>();
      case Type::UInt32:
        return this->readBinary<std::uint32_t>();
      case Type::Float32:
        return this->readBinary<float>();
      default:
        return this->readBinary<double>();
    }
  }

  template <typename T>
  double readBinary()
  {
    char bytes[sizeof(T)];
    if (!this->File.read(bytes, sizeof(T)))
    {
      this->fail("the file ends here; expected more bytes");
    }
    const std::uint16_t one = 1;
    const bool hostIsBig = *reinterpret_cast<const unsigned char*>(&one) == 0;
    if (this->BigEndian != hostIsBig)
    {
      std::reverse(std::begin(bytes), std::end(bytes));
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }

  const std::string& Path;
  std::ifstream File;
  std::string Place = "header";
  std::vector<Element> Elements;
  bool Ascii = false;
  bool BigEndian = false;
  Mesh Result;
};
}  // namespace

Mesh readPlyFile(const std::string& path)
{
  return PlyParser(path).parse();
}
}  // namespace kalos::scene
