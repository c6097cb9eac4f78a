// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lines of a text file and the words of a line, with the line's number for messages. A UTF-8 byte order
 * mark and carriage returns are removed. Numbers do not depend on the locale.
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
  /** The rest of the line, trimmed. */
  std::string rest() const;
  /** Reads the next word as a finite number; returns whether it is one. */
  bool number(double& value);

private:
  std::string_view Left;
};

/** Reads the whole word as a finite number. */
bool parseNumber(std::string_view word, double& value);
/** Reads the whole word as an integer. */
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
