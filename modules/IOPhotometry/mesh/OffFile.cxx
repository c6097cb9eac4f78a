// SPDX-License-Identifier: BSD-3-Clause
#include "OffFile.h"

#include "../base/InputError.h"
#include "../base/TextLines.h"

namespace kalos::scene
{
namespace
{
class OffParser
{
public:
  explicit OffParser(const std::string& path) : Lines(path) {}

  Mesh parse()
  {
    std::int64_t points = 0, polygons = 0;
    this->parseHeader(points, polygons);
    for (std::int64_t i = 0; i < points; ++i)
    {
      this->parsePoint(i, points);
    }
    for (std::int64_t i = 0; i < polygons; ++i)
    {
      this->parsePolygon(i, polygons);
    }
    return std::move(this->Result);
  }

private:
  /** The words of the next line that has any. */
  Words nextWords(const std::string& expected)
  {
    while (this->Lines.next())
    {
      Words words = this->Lines.words();
      if (Words(words).next() != std::string_view())
      {
        return words;
      }
    }
    this->Lines.fail("the file ends here; expected " + expected);
  }

  void parseHeader(std::int64_t& points, std::int64_t& polygons)
  {
    Words words = this->nextWords("the word OFF");
    const std::string_view word = words.next();
    if (word.size() < 3 || word.substr(word.size() - 3) != "OFF" || word.find_first_not_of("STCNOF4") != word.npos)
    {
      this->Lines.fail("no OFF header; expected the word OFF");
    }
    if (word.find('4') != word.npos)
    {
      this->Lines.fail("points of four coordinates; expected three");
    }
    if (Words(words).next().empty())
    {
      words = this->nextWords("the numbers of points and polygons");
    }
    if (!parseInteger(words.next(), points) || !parseInteger(words.next(), polygons) || points < 0 || polygons < 0)
    {
      this->Lines.fail("no numbers of points and polygons; expected two whole numbers of at least 0");
    }
  }

  void parsePoint(std::int64_t i, std::int64_t all)
  {
    Words words = this->nextWords(std::to_string(all - i) + " more points");
    Vector3 point;
    if (!words.number(point[0]) || !words.number(point[1]) || !words.number(point[2]))
    {
      this->Lines.fail("a point without three numbers; expected X Y Z");
    }
    this->Result.points.push_back(point);
  }

  void parsePolygon(std::int64_t i, std::int64_t all)
  {
    Words words = this->nextWords(std::to_string(all - i) + " more polygons");
    std::int64_t size = 0, corner = 0;
    const auto count = static_cast<std::int64_t>(this->Result.points.size());
    if (!parseInteger(words.next(), size) || size < 0)
    {
      this->Lines.fail("no number of corners; expected a whole number of at least 0");
    }
    std::vector<std::int64_t> corners;
    for (std::int64_t k = 0; k < size; ++k)
    {
      const std::string_view word = words.next();
      if (!parseInteger(word, corner) || corner < 0 || corner >= count)
      {
        this->Lines.fail("a corner '" + quotable(std::string(word)) + "'; expected " + std::to_string(size) +
                         " point numbers from 0 to " + std::to_string(count - 1));
      }
      corners.push_back(corner);
    }
    this->Result.addPolygon(corners, -1);
  }

  TextLines Lines;
  Mesh Result;
};
}  // namespace

Mesh readOffFile(const std::string& path)
{
  return OffParser(path).parse();
}
}  // namespace kalos::scene
