// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include <algorithm>
#include <map>

#include "../base/InputError.h"
#include "../base/TextLines.h"

namespace kalos::scene
{
namespace
{
/** Statements that do not affect light: other vertex data, lines, curves, appearance and grouping. */
constexpr const char* WithoutEffect[] = {
    "vt",     "vn",     "vp",     "s",   "l",    "p",    "lod",   "bevel", "c_interp",   "d_interp",
    "usemap", "maplib", "cstype", "deg", "bmat", "step", "curv",  "curv2", "parm",       "trim",
    "hole",   "scrv",   "sp",     "end", "con",  "mg",   "ctech", "stech", "shadow_obj", "trace_obj"};
/** Surfaces that are no polygons. */
constexpr const char* Curved[] = {"surf", "bsp", "bzp", "cdc", "cdp", "res"};

template <std::size_t N>
bool isAmong(const char* const (&list)[N], const std::string& word)
{
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

class ObjParser
{
public:
  ObjParser(const std::string& path, Notes& notes, Reading reading)
      : Lines(path, true), Found(notes), Lenient(reading == Reading::Lenient)
  {
    this->Result.objectNames.emplace_back();
  }

  ObjFile parse()
  {
    while (this->Lines.next())
    {
      this->parseLine();
    }
    if (this->HasColors)
    {
      const std::string& path = this->Lines.path();
      this->Found.count("colours of points", path.substr(path.find_last_of('/') + 1), "left out",
                        "materials alone count");
    }
    return std::move(this->Result);
  }

private:
  void parseLine()
  {
    Words words = this->Lines.words();
    const std::string keyword(words.next());
    if (keyword == "v")
    {
      this->parsePoint(words);
    }
    else if (keyword == "f" || keyword == "fo")
    {
      this->parseFace(words);
    }
    else if (keyword == "usemtl")
    {
      const std::string name = this->name();
      this->Material =
          name.empty() ? -1 : static_cast<std::int32_t>(number(this->Result.materialNames, this->Materials, name));
    }
    else if (keyword == "mtllib")
    {
      number(this->Result.libraries, this->Libraries, this->name());
    }
    else if (keyword == "o" || keyword == "g")
    {
      this->beginObject(keyword, this->name());
    }
    else if (!keyword.empty() && !isAmong(WithoutEffect, keyword))
    {
      this->passOver(keyword);
    }
  }

  void passOver(const std::string& keyword)
  {
    const bool curved = isAmong(Curved, keyword);
    if (!this->Lenient)
    {
      this->Lines.fail(curved ? "a curved surface ('" + keyword + "'); expected polygons"
                              : "unknown statement '" + quotable(keyword) +
                                    "'; expected v, f, usemtl or another of a polygon mesh");
    }
    this->Found.count(curved ? "curved surfaces" : "unknown statements", quotable(keyword), "left out",
                      "polygons alone are read");
  }

  void parsePoint(Words& words)
  {
    Vector3 point;
    if (!words.number(point[0]) || !words.number(point[1]) || !words.number(point[2]))
    {
      this->Lines.fail("a vertex without three numbers; expected v X Y Z");
    }
    this->Result.polygons.points.push_back(point);
    double color[3];
    this->HasColors = this->HasColors || (words.number(color[0]) && words.number(color[1]) && words.number(color[2]));
  }

  void parseFace(Words& words)
  {
    this->Corners.clear();
    const auto count = static_cast<std::int64_t>(this->Result.polygons.points.size());
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
      const std::string_view digits = word.substr(0, word.find('/'));
      std::int64_t index = 0;
      if (!parseInteger(digits, index) || index == 0 || index > count || index < -count)
      {
        this->Lines.fail("a face corner '" + quotable(std::string(digits)) + "'; expected a vertex number from 1 to " +
                         std::to_string(count));
      }
      this->Corners.push_back(index > 0 ? index - 1 : count + index);
    }
    this->Result.polygons.addPolygon(this->Corners, this->Material);
    this->Result.objectOf.push_back(this->Object);
  }

  /** What follows the keyword, up to the end of the line. */
  std::string name() const
  {
    Words words(this->Lines.text());
    words.next();
    return words.rest();
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

  /** Groups divide a file that has no objects. */
  void beginObject(const std::string& keyword, const std::string& name)
  {
    this->HasObjects = this->HasObjects || keyword == "o";
    if (keyword == "o" || !this->HasObjects)
    {
      this->Object = number(this->Result.objectNames, this->Objects, name);
    }
  }

  TextLines Lines;
  NoteCounter Found;
  bool Lenient;
  ObjFile Result;
  std::map<std::string, std::size_t> Libraries;
  std::map<std::string, std::size_t> Materials;
  std::map<std::string, std::size_t> Objects{{"", 0}};
  std::vector<std::int64_t> Corners;
  std::int32_t Material = -1;
  std::size_t Object = 0;
  bool HasObjects = false;
  bool HasColors = false;
};
}  // namespace

ObjFile readObjFile(const std::string& path, Notes& notes, Reading reading)
{
  return ObjParser(path, notes, reading).parse();
}
}  // namespace kalos::scene
