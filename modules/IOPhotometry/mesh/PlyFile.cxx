// SPDX-License-Identifier: BSD-3-Clause
#include "PlyFile.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "../base/InputError.h"
#include "PlyHeader.h"

namespace kalos::scene
{
namespace
{
/** One vertex, face or other item, as far as it concerns a mesh. */
struct Item
{
  Vector3 point{};
  int coordinates = 0;
  std::vector<std::int64_t> corners;
  bool hasCorners = false;
};

class PlyParser
{
public:
  explicit PlyParser(const std::string& path) : Path(path), File(path, std::ios::binary) {}

  Mesh parse(Notes& notes)
  {
    this->Header = readPlyHeader(this->File, this->Path);
    this->tellColors(notes);
    for (const PlyElement& element : this->Header.elements)
    {
      for (std::int64_t i = 0; i < element.size; ++i)
      {
        this->Place = &element;
        this->Index = i;
        this->take(element.name, this->parseItem(element));
      }
    }
    return std::move(this->Result);
  }

private:
  [[noreturn]] void fail(const std::string& what) const
  {
    throw InputError(this->Path, this->Place->name + " " + std::to_string(this->Index + 1), what);
  }

  void tellColors(Notes& notes) const
  {
    for (const PlyElement& element : this->Header.elements)
    {
      const auto isColor = [](const PlyProperty& p) { return p.name == "red" || p.name == "diffuse_red"; };
      if (element.size > 0 && std::any_of(element.properties.begin(), element.properties.end(), isColor))
      {
        notes.push_back({"colours of a PLY", "left out", "materials alone count (" + element.name + ")"});
      }
    }
  }

  Item parseItem(const PlyElement& element)
  {
    Item item;
    for (const PlyProperty& property : element.properties)
    {
      const bool list = property.count != PlyType::None;
      const bool wanted = list && property.name.rfind("vertex_ind", 0) == 0;
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
          item.corners.push_back(asIndex(value));
        }
        else if (!list && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
        {
          item.point[property.name[0] - 'x'] = value;
          ++item.coordinates;
        }
      }
      item.hasCorners = item.hasCorners || wanted;
    }
    return item;
  }

  void take(const std::string& element, const Item& item)
  {
    const bool strips = element == "tristrips";
    if (element == "vertex")
    {
      if (item.coordinates != 3)
      {
        this->fail("vertices without x, y and z; expected all three");
      }
      this->Result.points.push_back(item.point);
    }
    else if (element == "face" || strips)
    {
      if (!item.hasCorners)
      {
        this->fail((strips ? "strips" : "faces") + std::string(" without the list vertex_indices; expected it"));
      }
      strips ? this->addStrips(item.corners) : this->Result.addPolygon(item.corners, -1);
    }
  }

  /** Every other triangle of a strip has its corners turned. */
  void addStrips(const std::vector<std::int64_t>& corners)
  {
    std::size_t start = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (corners[i] < 0)
      {
        start = i + 1;
      }
      else if (i >= start + 2)
      {
        const std::size_t odd = (i - start) % 2;
        const std::int64_t a = corners[i - 2 + odd], b = corners[i - 1 - odd];
        // Degenerate triangles only continue the strip elsewhere.
        if (a != b && b != corners[i] && a != corners[i])
        {
          this->Result.addPolygon({a, b, corners[i]}, -1);
        }
      }
    }
  }

  /** Out of range becomes -1, which the mesh check names; a cast would be undefined. */
  static std::int64_t asIndex(double value)
  {
    return value >= 0.0 && value < 9e15 ? static_cast<std::int64_t>(value) : -1;
  }

  double readNumber(PlyType type)
  {
    if (this->Header.ascii)
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
      case PlyType::Int8:
        return this->readBinary<std::int8_t>();
      case PlyType::UInt8:
        return this->readBinary<std::uint8_t>();
      case PlyType::Int16:
        return this->readBinary<std::int16_t>();
      case PlyType::UInt16:
        return this->readBinary<std::uint16_t>();
      case PlyType::Int32:
        return this->readBinary<std::int32_t>();
      case PlyType::UInt32:
        return this->readBinary<std::uint32_t>();
      case PlyType::Float32:
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
    return static_cast<double>(fromBytes<T>(bytes, this->Header.order));
  }

  const std::string& Path;
  std::ifstream File;
  PlyHeader Header;
  const PlyElement* Place = nullptr;
  std::int64_t Index = 0;
  Mesh Result;
};
}  // namespace

Mesh readPlyFile(const std::string& path, Notes& notes)
{
  return PlyParser(path).parse(notes);
}
}  // namespace kalos::scene
