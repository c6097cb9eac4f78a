// SPDX-License-Identifier: BSD-3-Clause
// Lines and numbers of a photometric file, each with its place for messages.
#ifndef kalos_photometry_PhotometryText_h
#define kalos_photometry_PhotometryText_h

#include <string>
#include <vector>

#include "photometry/PhotometricFile.h"

namespace kalos
{
/// A number as short as it reads back, for messages.
std::string shortNumber(double value);

/// Whether the line is the TILT= of an LM-63 file.
bool isTiltLine(const std::string& line);

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
  /// Whatever follows on the current line is done with.
  void endLine();
  bool onlyBlanksLeft();

  /// Decimal commas are read as points, one number to a word; EULUMDAT only.
  void allowDecimalCommas() { this->CommaIsPoint = true; }
  int decimalComma() const { return this->FirstComma; }  ///< line of the first one, 0 for none

  [[noreturn]] void fail(const std::string& field, const std::string& what) const;

private:
  bool readWord(std::string& word);

  std::vector<std::string> Lines;
  std::size_t Bytes = 0;   // of all lines
  int Next = 0;            // line to read next
  std::size_t Column = 0;  // in line Next - 1; npos when that is used up
  bool CommaIsPoint = false;
  int FirstComma = 0;
};
}  // namespace kalos

#endif
