// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/PhotometryText.h"

#include <charconv>

namespace kalos
{
namespace
{
constexpr const char* blanks = " \t\v\f";

std::string quoted(const std::string& word)
{
  std::string text = word.substr(0, 20);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > 126)
      c = '?';
  return "\"" + text + (word.size() > 20 ? "...\"" : "\"");
}

std::string trimmed(const std::string& line)
{
  const auto first = line.find_first_not_of(blanks), last = line.find_last_not_of(blanks);
  return first == std::string::npos ? std::string() : line.substr(first, last - first + 1);
}
}  // namespace

std::string shortNumber(double value)
{
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

std::string upperCase(std::string text)
{
  for (char& c : text)
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

bool isTiltLine(const std::string& line)
{
  if (upperCase(line.substr(0, 4)) != "TILT")
    return false;
  const auto equals = line.find_first_not_of(blanks, 4);
  return equals != std::string::npos && line[equals] == '=';
}

PhotometryText::PhotometryText(const std::string& text)
{
  if (text.size() > maxPhotometryBytes)
    throw PhotometryError(1, "file", "larger than 16 MiB; expected a photometric file");
  if (text.size() > 1 && ((text[0] == '\xff' && text[1] == '\xfe') || (text[0] == '\xfe' && text[1] == '\xff')))
    throw PhotometryError(1, "file", "UTF-16 text; expected ASCII, Latin-1 or UTF-8");
  std::size_t begin = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  const std::size_t stop = std::min(text.size(), text.find('\x1a', begin));
  while (begin < stop)
  {
    const std::size_t end = std::min(stop, text.find_first_of("\r\n", begin));
    this->Lines.push_back(trimmed(text.substr(begin, end - begin)));
    this->Bytes += this->Lines.back().size() + 1;
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  if (this->Bytes <= this->Lines.size())
    throw PhotometryError(1, "file", "nothing but blanks; expected a photometric file");
}

std::string PhotometryText::readLine(const std::string& field)
{
  if (this->Next >= this->size())
    this->fail(field, "the file ends before it; expected a line");
  this->Column = std::string::npos;
  return this->Lines[this->Next++];
}

bool PhotometryText::readWord(std::string& word)
{
  const std::string separators = this->CommaIsPoint ? " \t\v\f" : " \t\v\f,";
  for (;;)
  {
    if (this->Next > 0 && this->Column != std::string::npos)
    {
      const std::string& line = this->Lines[this->Next - 1];
      const std::size_t begin = line.find_first_not_of(separators, this->Column);
      if (begin != std::string::npos)
      {
        const std::size_t end = line.find_first_of(separators, begin);
        word = line.substr(begin, end == std::string::npos ? end : end - begin);
        this->Column = end;
        return true;
      }
    }
    if (this->Next >= this->size())
      return false;
    this->BlankBefore = this->Lines[this->Next].empty() ? this->Next + 1 : this->BlankBefore;
    ++this->Next;
    this->Column = 0;
  }
}

bool PhotometryText::onlyBlanksLeft()
{
  std::string word;
  return !this->readWord(word);
}

double PhotometryText::readNumber(const std::string& field)
{
  std::string word;
  if (!this->readWord(word))
    this->fail(field, "the file ends before it" +
                          (this->BlankBefore ? ", and line " + std::to_string(this->BlankBefore) + " is blank" : "") +
                          "; expected a number");
  return this->parseWord(word, field);
}

double PhotometryText::parseWord(std::string word, const std::string& field)
{
  const auto comma = this->CommaIsPoint ? word.find(',') : std::string::npos;
  if (comma != std::string::npos)
  {
    word[comma] = '.';
    if (!this->FirstComma)
      this->FirstComma = this->line();
  }
  const char* begin = word.data() + (word[0] == '+' && word.size() > 1 && word[1] != '-' ? 1 : 0);
  const char* end = word.data() + word.size();
  double value = 0;
  const auto result = std::from_chars(begin, end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end)
    this->fail(field, "found " + quoted(word) + "; expected a number");
  if (result.ec != std::errc() || !std::isfinite(value))
    this->fail(field, "found " + quoted(word) + "; expected a number of ordinary size");
  return value;
}

double PhotometryText::readLineNumber(const std::string& field, std::optional<double> absent)
{
  if (this->Next >= this->size())
    this->fail(field, "the file ends before it; expected a number");
  std::string line = this->readLine(field);
  if (line.empty() && absent)
  {
    this->FirstAbsent = this->FirstAbsent ? this->FirstAbsent : this->line();
    return *absent;
  }
  if (line.empty())
    this->fail(field, "blank; expected a number");
  const auto isDigit = [&line](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  // 2 000 is two thousand, not two.
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    if (line[i] == ' ' && isDigit(i - 1) && isDigit(i + 1) && isDigit(i + 2) && isDigit(i + 3) && !isDigit(i + 4))
    {
      line.erase(i, 1);
      this->FirstGroup = this->FirstGroup ? this->FirstGroup : this->line();
    }
  }
  const std::size_t end = std::min(line.find_first_of(blanks), line.size());
  const std::string rest = trimmed(line.substr(end));
  if (!rest.empty() && ((rest[0] >= '0' && rest[0] <= '9') || rest[0] == '-' || rest[0] == '.' || rest[0] == ','))
    this->fail(field, "found " + quoted(line) + "; expected one number");
  return this->parseWord(line.substr(0, end), field);
}

int PhotometryText::checkCount(double value, const std::string& field, int low, int high) const
{
  if (!(value >= low && value <= high && value == std::floor(value)))
    this->fail(field, "found " + shortNumber(value) + "; expected a whole number from " + std::to_string(low) + " to " +
                          std::to_string(high));
  return static_cast<int>(value);
}

int PhotometryText::readCount(const std::string& field, int low, int high)
{
  return this->checkCount(this->readNumber(field), field, low, high);
}

int PhotometryText::readLineCount(const std::string& field, int low, int high)
{
  return this->checkCount(this->readLineNumber(field), field, low, high);
}

std::vector<double> PhotometryText::readNumbers(const std::string& field, std::size_t count)
{
  // Each needs a digit and a separator.
  if (count > (this->Bytes + 1) / 2)
    this->fail(field, std::to_string(count) + " numbers announced, more than the file holds; expected right counts");
  std::vector<double> numbers(count);
  this->BlankBefore = 0;
  for (std::size_t i = 0; i < count; ++i)
    numbers[i] = this->readNumber(field + " " + std::to_string(i + 1) + " of " + std::to_string(count));
  return numbers;
}

void PhotometryText::fail(const std::string& field, const std::string& what) const
{
  throw PhotometryError(this->line(), field, what);
}
}  // namespace kalos
