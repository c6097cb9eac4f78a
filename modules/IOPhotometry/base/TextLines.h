// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lines of a text file and the words of a line, with the line's number for messages. A mark of UTF-8 at the start
 * and carriage returns do not show. Numbers are read without regard to the user's locale.
 */
#ifndef KalosTextLines_h
#define KalosTextLines_h

#include <fstream>
#include <string>
#include <string_view>

namespace kalos::scene
{
/** Words of a line, separated by blanks and tabs. */
class Words
{
public:
  explicit Words(std::string_view line) : Left(line) {}

  /** The next word, empty at the end. */
  std::string_view next();
  /** All that is left, without blanks at its ends. */
  std::string rest() const;
  /** The next word as a finite number; whether it is one. */
  bool number(double& value);

private:
  std::string_view Left;
};

/** The whole word as a finite number. */
bool parseNumber(std::string_view word, double& value);
/** The whole word as an integer. */
bool parseInteger(std::string_view word, std::int64_t& value);
/** `text` without blanks, tabs and carriage returns at its ends. */
std::string_view trimmed(std::string_view text);
/** In small letters, ASCII only. */
std::string lowerCase(std::string_view text);

class TextLines
{
public:
  /** With `continued`, a backslash at the end of a line joins the next one. `path` must outlive this. */
  explicit TextLines(const std::string& path, bool continued = false);

  /** Go to the next line; false at the end. */
  bool next();
  const std::string& text() const { return this->Line; }
  const std::string& path() const { return this->Path; }
  /** The words before a comment that `#` begins. */
  Words words() const { return Words(std::string_view(this->Line).substr(0, this->Line.find('#'))); }
  /** Throw an InputError about this line. */
  [[noreturn]] void fail(const std::string& what) const;

private:
  bool read(std::string& line);

  const std::string& Path;
  std::ifstream File;
  std::string Line;
  long long Number = 0;
  bool Continued;
};
}  // namespace kalos::scene

#endif
