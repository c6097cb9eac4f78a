// SPDX-License-Identifier: BSD-3-Clause
#include "TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "InputError.h"

namespace kalos::scene
{
namespace
{
constexpr const char* Blanks = " \t\v\f\r";
constexpr std::string_view Utf8Mark = "\xEF\xBB\xBF";
}  // namespace

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(Blanks) + 1 - first);
}

std::string lowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

bool parseNumber(std::string_view word, double& value)
{
  word.remove_prefix(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A number too small for a double is as good as zero.
  if (error == std::errc::result_out_of_range && end == word.data() + word.size())
  {
    value = std::strtod(std::string(word).c_str(), nullptr);
    return std::abs(value) < 1.0;
  }
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

bool parseInteger(std::string_view word, std::int64_t& value)
{
  word.remove_prefix(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::string_view Words::next()
{
  const std::size_t first = std::min(this->Left.find_first_not_of(Blanks), this->Left.size());
  const std::size_t last = std::min(this->Left.find_first_of(Blanks, first), this->Left.size());
  const std::string_view word = this->Left.substr(first, last - first);
  this->Left.remove_prefix(last);
  return word;
}

std::string Words::rest() const
{
  return std::string(trimmed(this->Left));
}

bool Words::number(double& value)
{
  return parseNumber(this->next(), value);
}

TextLines::TextLines(const std::string& path, bool continued)
    : Path(path), File(path, std::ios::binary), Continued(continued)
{
}

bool TextLines::next()
{
  if (!this->read(this->Line))
  {
    return false;
  }
  std::string more;
  while (this->Continued && !this->Line.empty() && this->Line.back() == '\\')
  {
    this->Line.back() = ' ';
    if (!this->read(more))
    {
      break;
    }
    this->Line += more;
  }
  return true;
}

bool TextLines::read(std::string& line)
{
  if (!std::getline(this->File, line))
  {
    return false;
  }
  if (++this->Number == 1 && line.compare(0, Utf8Mark.size(), Utf8Mark) == 0)
  {
    line.erase(0, Utf8Mark.size());
  }
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return true;
}

void TextLines::fail(const std::string& what) const
{
  throw InputError(this->Path, "line " + std::to_string(this->Number), what);
}
}  // namespace kalos::scene
