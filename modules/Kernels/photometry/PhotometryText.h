// SPDX-License-Identifier: BSD-3-Clause
// Lines and numbers of a photometric file, each with its place for messages.
#ifndef kalos_photometry_PhotometryText_h
#define kalos_photometry_PhotometryText_h

#include <optional>
#include <string>
#include <vector>

#include "photometry/PhotometricFile.h"

namespace kalos
{
/// A number as short as it reads back, for messages.
std::string shortNumber(double value);

/// In capitals, ASCII only: keywords stand in files in any case.
std::string upperCase(std::string text);

/// Whether the line is the TILT= of an LM-63 file.
bool isTiltLine(const std::string& line);

/// Whether the line, in capitals, is the first of an LM-63 file later than 1986, in one of its spellings.
bool isIesHeader(const std::string& line);

/// Lines ended by LF, CR LF or CR, without blanks at both ends; a byte order mark and a final Ctrl-Z are dropped.
class PhotometryText
{
public:
  /// Throws for an empty, a too long, and a UTF-16 file.
  explicit PhotometryText(const std::string& text);

  int size() const { return static_cast<int>(this->Lines.size()); }
  int line() const { return std::min(this->Next, this->size()); }          ///< of what was read last, from 1
  const std::string& peek(int index) const { return this->Lines[index]; }  ///< index from 0

  /// The next line as a whole; throws at the end of the file.
  std::string readLine(const std::string& field);
  void skipLines(int count) { this->Next += count; }

  /// The next number, separated by blanks, commas or line ends; throws when it is missing, no number or not finite.
  double readNumber(const std::string& field);
  /// A whole number in [low, high].
  int readCount(const std::string& field, int low, int high);
  /// `count` numbers; throws before reading when the rest of the file is too short to hold them.
  std::vector<double> readNumbers(const std::string& field, std::size_t count);
  /// The number on the next line, of which it is all but for text such as a unit; blanks between groups of three digits
  /// are passed over. A blank line is `absent`, or an error without.
  double readLineNumber(const std::string& field, std::optional<double> absent = {});
  int readLineCount(const std::string& field, int low, int high);
  bool onlyBlanksLeft();

  /// Decimal commas are read as points, one number to a word.
  void allowDecimalCommas() { this->CommaIsPoint = true; }
  int decimalComma() const { return this->FirstComma; }   ///< line of the first one, 0 for none
  int blankNumber() const { return this->FirstAbsent; }   ///< line of the first number that is absent, 0 for none
  int groupedNumber() const { return this->FirstGroup; }  ///< line of the first number with blanks in it, 0 for none

  [[noreturn]] void fail(const std::string& field, const std::string& what) const;

private:
  bool readWord(std::string& word);
  double parseWord(std::string word, const std::string& field);
  int checkCount(double value, const std::string& field, int low, int high) const;

  std::vector<std::string> Lines;
  std::size_t Bytes = 0;   // of all lines
  int Next = 0;            // line to read next
  std::size_t Column = 0;  // in line Next - 1; npos when that is used up
  bool CommaIsPoint = false;
  int FirstComma = 0, FirstAbsent = 0, FirstGroup = 0;
  int BlankBefore = 0;  // the last blank line among those that numbers were looked for in
};
}  // namespace kalos

#endif
