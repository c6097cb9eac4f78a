// SPDX-License-Identifier: BSD-3-Clause
#include "MtlStatements.h"

#include <cmath>

#include "../base/InputError.h"
#include "../base/TextLines.h"

namespace kalos::scene
{
void MtlEntry::fail(const Statement& statement, double highest) const
{
  throw InputError(this->Path, "line " + std::to_string(statement.line),
                   "no number, or one that is out of range; expected at least 0" +
                       (highest < 100.0 ? " and at most " + std::to_string(static_cast<int>(highest)) : ""));
}

double MtlEntry::number(const std::string& keyword, double absent, double highest) const
{
  const auto found = this->Statements.find(keyword);
  if (found == this->Statements.end())
  {
    return absent;
  }
  Words words(found->second.text);
  std::string_view word = words.next();
  double value = 0.0;
  if (word.size() > 1 && word[0] == '-' && !parseNumber(word, value))
  {
    word = words.next();
  }
  if (!parseNumber(word, value) || !(value >= 0.0 && value <= highest))
  {
    this->fail(found->second, highest);
  }
  return value;
}

std::array<double, 3> MtlEntry::color(const std::string& keyword, double absent, double highest) const
{
  const auto found = this->Statements.find(keyword);
  if (found == this->Statements.end())
  {
    return {absent, absent, absent};
  }
  std::array<double, 3> color{};
  Words words(found->second.text);
  for (int c = 0; c < 3; ++c)
  {
    const std::string_view word = words.next();
    if (c == 1 && word.empty())
    {
      return {color[0], color[0], color[0]};
    }
    if (!parseNumber(word, color[c]) || !(color[c] >= 0.0 && color[c] <= highest))
    {
      this->fail(found->second, highest);
    }
  }
  return color;
}

std::string MtlEntry::file(const std::string& keyword) const
{
  const auto found = this->Statements.find(keyword);
  if (found == this->Statements.end())
  {
    return {};
  }
  Words words(found->second.text);
  for (Words ahead = words;; words = ahead)
  {
    const std::string_view option = ahead.next();
    if (option.size() < 2 || option[0] != '-')
    {
      return words.rest();
    }
    const bool vector = option == "-o" || option == "-s" || option == "-t";
    ahead.next();
    ahead = option == "-mm" ? (ahead.next(), ahead) : ahead;
    double value = 0.0;
    for (Words more = ahead; vector && more.number(value);)
    {
      ahead = more;
    }
  }
}

std::vector<MtlEntry> readMtlStatements(const std::string& path)
{
  std::vector<MtlEntry> entries;
  TextLines lines(path);
  for (long long line = 1; lines.next(); ++line)
  {
    Words words = lines.words();
    const std::string keyword = lowerCase(words.next());
    // Names reach to the end of the line, with any # in them.
    Words whole(lines.text());
    whole.next();
    if (keyword == "newmtl")
    {
      if (whole.rest().empty())
      {
        lines.fail("newmtl without a name; expected the name of a material");
      }
      entries.emplace_back(whole.rest(), path);
    }
    else if (!keyword.empty() && !entries.empty())
    {
      entries.back().add(keyword, keyword.compare(0, 4, "map_") == 0 ? whole.rest() : words.rest(), line);
    }
  }
  return entries;
}
}  // namespace kalos::scene
