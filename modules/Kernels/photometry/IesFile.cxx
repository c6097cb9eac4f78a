// SPDX-License-Identifier: BSD-3-Clause
// IES LM-63-1986, 1991, 1995, 2002 and 2019.
//
// Warnings: ies-version (unknown standard, read as 2002), ies-reversed (angles descend), ies-range (a range that the
// standards do not foresee, and what is taken for it), ies-seam (planes 0 and 360 differ), ies-lamp-lumens (no lumens
// for relative photometry), ies-future-use (a factor where the standard wants 1), ies-flux (more light than the lamps
// give), ies-trailing (text after the last intensity), ies-opening (a shape that is not flat, or a line),
// ies-decimal-comma (read as a point).
#include <algorithm>
#include <optional>

#include "photometry/IesPlanes.h"
#include "photometry/PhotometryTable.h"
#include "photometry/PhotometryText.h"

namespace kalos
{
namespace
{
constexpr int maxAngles = 100000;
constexpr double lineWidth = 1e-3;  // of the strip that stands for a line, over its length

class IesReader
{
public:
  IesReader(const std::string& text, const PhotometryOptions& options, bool decimalCommas)
      : Text(text), Options(options)
  {
    if (decimalCommas)
      this->Text.allowDecimalCommas();
  }
  PhotometricFile read();

private:
  void warn(const char* code, const std::string& field, const std::string& text)
  {
    this->Warnings.push_back({code, this->Text.line(), field, text});
  }
  void readVersion();
  void readKeywords();
  void readTilt(const std::string& line);
  void readTiltTable(PhotometryText& text);
  void readAngles(PhotometryRows& rows);
  void readCandela(PhotometryRows& rows, bool transposed);
  Opening readOpening(double metres);

  PhotometryText Text;
  const PhotometryOptions& Options;
  int Year = 1986;
  std::string Name;
  int VerticalCount = 0, HorizontalCount = 0, AnglesLine = 0;
  std::vector<double> TiltAngles, TiltFactors;
  std::vector<PhotometryWarning> Warnings;
};

void IesReader::readVersion()
{
  // LM-63-1986 had neither a first line nor keywords: its lines are free text.
  int index = 0;
  while (index + 1 < this->Text.size() && this->Text.peek(index).empty())
    ++index;
  const std::string first = upperCase(this->Text.peek(index));
  if (!isIesHeader(first))
    return;
  for (int i = 0; i <= index; ++i)
    this->Text.readLine("version");
  this->Year = 2002;
  for (const char* year : {"1986", "1991", "1995", "2002", "2019"})
  {
    if (first.find(year) != std::string::npos)
    {
      this->Year = std::stoi(year);
      return;
    }
  }
  if (first.size() > 1 && first.compare(first.size() - 2, 2, "91") == 0)
    this->Year = 1991;
  else
    this->warn("ies-version", "version", "an LM-63 of no known year; read as LM-63-2002");
}

void IesReader::readKeywords()
{
  this->readVersion();
  for (;;)
  {
    const std::string line = this->Text.readLine("TILT");
    if (isTiltLine(line))
      return this->readTilt(line.substr(line.find('=') + 1));
    for (const std::string key : {"[LUMINAIRE]", "[LUMCAT]"})
      if (this->Name.empty() && upperCase(line.substr(0, key.size())) == key)
      {
        const auto begin = line.find_first_not_of(" \t", key.size());
        this->Name = begin == std::string::npos ? "" : line.substr(begin, 80);
      }
  }
}

void IesReader::readTilt(const std::string& value)
{
  const auto begin = value.find_first_not_of(" \t");
  const std::string name = begin == std::string::npos ? "" : value.substr(begin);
  if (upperCase(name) == "NONE")
    return;
  if (upperCase(name) == "INCLUDE")
    return this->readTiltTable(this->Text);
  if (name.empty())
    this->Text.fail("TILT", "no value; expected NONE, INCLUDE or the name of a file");
  const auto text = this->Options.findTilt ? this->Options.findTilt(name) : std::nullopt;
  if (!text)
    this->Text.fail("TILT", "there is no file of that name beside this one; expected NONE, INCLUDE or a tilt file");
  try
  {
    PhotometryText tilt(*text);
    this->readTiltTable(tilt);
  }
  catch (const PhotometryError& error)
  {
    this->Text.fail("TILT", std::string("the tilt file is damaged, ") + error.what());
  }
}

void IesReader::readTiltTable(PhotometryText& text)
{
  text.readCount("lamp to luminaire geometry", 1, 3);
  const int count = text.readCount("number of tilt angles", 1, maxAngles);
  this->TiltAngles = text.readNumbers("tilt angle", count);
  checkOrder(this->TiltAngles, text.line(), "tilt angle", false);
  this->TiltFactors = text.readNumbers("tilt factor", count);
  for (double factor : this->TiltFactors)
    if (!(factor >= 0 && factor < 1000))
      text.fail("tilt factor", "found " + shortNumber(factor) + "; expected a factor from 0 to 1000");
}

Opening IesReader::readOpening(double metres)
{
  // Negative sizes mark round shapes: LM-63-2002, table 1; one negative size alone is a circle of LM-63-1995, where a
  // horizontal cylinder has its length and its diameter, negative, as the height.
  const double width = this->Text.readNumber("luminous width") * metres;
  const double length = this->Text.readNumber("luminous length") * metres;
  const double height = this->Text.readNumber("luminous height") * metres;
  for (double size : {width, length, height})
    if (!(std::abs(size) < 1000))
      this->Text.fail("luminous size", "found " + shortNumber(size) + " m; expected less than 1000 m");
  Opening opening;
  opening.round = width < 0 && length <= 0;
  opening.alongC90 = std::abs(width);
  opening.alongC0 = opening.round && length == 0 ? opening.alongC90 : std::abs(length);
  opening.height = std::abs(height);
  if (!opening.round && (width == 0) != (length == 0))
  {
    const bool cylinder = height < 0 && width >= 0 && length >= 0;
    double& across = width == 0 ? opening.alongC90 : opening.alongC0;
    across = cylinder ? opening.height : lineWidth * std::max(opening.alongC0, opening.alongC90);
    this->warn("ies-opening", "luminous size",
               cylinder ? "a horizontal cylinder; taken as a flat strip of its length and diameter"
                        : "no size in one direction; taken as a strip a thousandth as wide as it is long");
  }
  return opening;
}

void IesReader::readAngles(PhotometryRows& rows)
{
  rows.angles = this->Text.readNumbers("vertical angle", this->VerticalCount);
  checkOrder(rows.angles, this->Text.line(), "vertical angle", true);
  rows.planes = this->Text.readNumbers("horizontal angle", this->HorizontalCount);
  checkOrder(rows.planes, this->Text.line(), "horizontal angle", true);
  this->AnglesLine = this->Text.line();
}

void IesReader::readCandela(PhotometryRows& rows, bool transposed)
{
  const std::size_t columns = rows.angles.size();
  const std::vector<double> all = this->Text.readNumbers("candela", rows.planes.size() * columns);
  for (std::size_t p = 0; p < rows.planes.size(); ++p)
    rows.candela.emplace_back(all.begin() + p * columns, all.begin() + (p + 1) * columns);
  if (rows.makeAscending())
    this->warn("ies-reversed", "angles", "they descend; read backwards");
  if (!transposed)
    return;
  PhotometryRows turned{rows.angles, rows.planes, {}};
  for (std::size_t a = 0; a < columns; ++a)
  {
    turned.candela.emplace_back();
    for (const auto& row : rows.candela)
      turned.candela.back().push_back(row[a]);
  }
  rows = std::move(turned);
}

PhotometricFile IesReader::read()
{
  this->readKeywords();
  const int lamps = this->Text.readCount("number of lamps", 1, 10000);
  const double lumens = this->Text.readNumber("lumens per lamp");
  if (!(lumens == -1 || (lumens >= 0 && lumens < 1e12)))
    this->Text.fail("lumens per lamp", "found " + shortNumber(lumens) + "; expected 0 or more, or -1 for absolute");
  if (lumens == 0)
    this->warn("ies-lamp-lumens", "lumens per lamp", "0, yet the photometry is relative; the flux is not compared");
  auto readFactor = [this](const std::string& field) {
    const double factor = this->Text.readNumber(field);
    if (!(factor > 0 && factor < 1e9))
      this->Text.fail(field, "found " + shortNumber(factor) + "; expected a factor above 0");
    return factor;
  };
  double factor = readFactor("candela multiplier");
  this->VerticalCount = this->Text.readCount("number of vertical angles", 2, maxAngles);
  this->HorizontalCount = this->Text.readCount("number of horizontal angles", 1, maxAngles);
  const int type = this->Text.readCount("photometric type", 1, 3);
  const double metres = this->Text.readCount("units type", 1, 2) == 1 ? 0.3048 : 1;
  const Opening opening = this->readOpening(metres);
  const double ballast = readFactor("ballast factor");
  const double future = readFactor("ballast-lamp factor");
  this->Text.readNumber("input watts");
  // LM-63-2019 tells there how the file came about; 1995 and 2002 keep the field for the future.
  if (this->Year < 2019)
    factor *= future;
  if (this->Year >= 1995 && this->Year < 2019 && future != 1)
    this->warn("ies-future-use", "ballast-lamp factor", shortNumber(future) + " where the standard wants 1; applied");
  factor *= ballast;

  PhotometryRows rows;
  this->readAngles(rows);
  if (type != 1 && rows.planes.size() < 2)
    this->Text.fail("number of horizontal angles", "found 1; expected 2 or more in types A and B");
  this->readCandela(rows, type == 2);
  checkCandela(rows, this->Text.line());
  const int lastLine = this->Text.line();
  rows.scale(factor);
  completeIesPlanes(rows, type, {this->AnglesLine, lastLine}, this->Warnings);
  if (!this->Text.onlyBlanksLeft())
    this->warn("ies-trailing", "candela", "more text follows the last intensity; passed over");
  if (this->Text.decimalComma())
    this->Warnings.push_back(
        {"ies-decimal-comma", this->Text.decimalComma(), "number", "a decimal comma; read as a point"});

  PhotometricFile file{this->Year == 1986 ? "IES LM-63-1986" : "IES LM-63-" + std::to_string(this->Year), this->Name,
                       rows.table(type == 2 ? CandelaTable::Pole::Side : CandelaTable::Pole::Axis)};
  file.lampFlux = lumens > 0 ? lamps * lumens : 0;
  file.opening = opening;
  file.tiltAngles = this->TiltAngles;
  file.tiltFactors = this->TiltFactors;
  if (file.lampFlux > 0 && file.table.flux() > 1.01 * file.lampFlux * ballast)
    this->Warnings.push_back({"ies-flux", lastLine, "lumens per lamp",
                              "the intensities make " + shortNumber(std::round(file.table.flux())) +
                                  " lm, more than the lamps' " + shortNumber(std::round(file.lampFlux * ballast))});
  file.warnings = this->Warnings;
  return file;
}
}  // namespace

bool isIesHeader(const std::string& line)
{
  const bool named = line.find("LM-63") != std::string::npos || line.find("LM63") != std::string::npos;
  return line.compare(0, 5, "IESNA") == 0 || line.compare(0, 4, "IES:") == 0 ||
         (line.compare(0, 3, "IES") == 0 && named);
}

PhotometricFile parseIes(const std::string& text, const PhotometryOptions& options)
{
  // A comma parts numbers; but where numbers are left over, or something does not fit, it may be a decimal one, if then
  // all fits.
  const auto fits = [](const PhotometricFile& file) {
    return std::none_of(file.warnings.begin(), file.warnings.end(),
                        [](const PhotometryWarning& w) { return w.code == "ies-trailing"; });
  };
  std::optional<PhotometricFile> file;
  std::optional<PhotometryError> problem;
  try
  {
    file = IesReader(text, options, false).read();
  }
  catch (const PhotometryError& error)
  {
    problem = error;
  }
  if (file && fits(*file))
    return *file;
  try
  {
    const PhotometricFile other = IesReader(text, options, true).read();
    if (fits(other))
      return other;
  }
  catch (const PhotometryError&)
  {
  }
  if (problem)
    throw *problem;
  return *file;
}
}  // namespace kalos
