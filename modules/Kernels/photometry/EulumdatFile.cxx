// SPDX-License-Identifier: BSD-3-Clause
// EULUMDAT (.ldt; Stockmar 1990).
//
// Warnings: ldt-decimal-comma (read as a point), ldt-digit-groups (2 000 is 2000), ldt-blank (a number that is left
// out, taken as 0), ldt-negative-lamps (absolute photometry), ldt-light-output-ratio (contradicts the intensities,
// which are used), ldt-flux (more light than the lamps give), ldt-trailing (text after the last intensity).
#include "photometry/PhotometryTable.h"
#include "photometry/PhotometryText.h"

namespace kalos
{
namespace
{
constexpr int maxAngles = 100000, maxLampSets = 20;
constexpr double degreesClosed = 0.01;

class EulumdatReader
{
public:
  EulumdatReader(const std::string& text, const PhotometryOptions& options) : Text(text), Options(options)
  {
    this->Text.allowDecimalCommas();
  }
  PhotometricFile read();

private:
  void warn(const char* code, const std::string& field, const std::string& text)
  {
    this->Warnings.push_back({code, this->Text.line(), field, text});
  }
  double size(const std::string& field);  // m, from mm; many leave out what is 0
  void tellSpelling();
  Opening readOpening();
  double readLampSets();  // lm of the chosen set
  PhotometryRows readRows();
  void complete(PhotometryRows& rows);

  PhotometryText Text;
  const PhotometryOptions& Options;
  int Symmetry = 0, PlaneCount = 0, AngleCount = 0, SetCount = 0;
  bool Absolute = false;
  std::vector<PhotometryWarning> Warnings;
};

double EulumdatReader::size(const std::string& field)
{
  const double value = this->Text.readLineNumber(field, 0.0);
  if (!(value >= 0 && value < 1e6))
    this->Text.fail(field, "found " + shortNumber(value) + "; expected millimetres from 0 to a million");
  return value / 1000;
}

Opening EulumdatReader::readOpening()
{
  // EN 13032-1: the plane C = 0 lies across a long luminaire, its length runs along C = 90.
  Opening opening;
  opening.alongC90 = this->size("length of the luminous area");
  opening.alongC0 = this->size("width of the luminous area");
  if (opening.alongC0 == 0)
  {
    opening.round = true;
    opening.alongC0 = opening.alongC90;
  }
  for (const char* plane : {"C0", "C90", "C180", "C270"})
    opening.height = std::max(opening.height, this->size(std::string("height of the luminous area, ") + plane));
  return opening;
}

double EulumdatReader::readLampSets()
{
  this->SetCount = this->Text.readLineCount("number of lamp sets", 1, maxLampSets);
  if (this->Options.lampSet < 1 || this->Options.lampSet > this->SetCount)
    this->Text.fail("number of lamp sets", "there are " + std::to_string(this->SetCount) + ", but set " +
                                               std::to_string(this->Options.lampSet) +
                                               " is asked for; expected one of them");
  double flux = 0;
  for (int set = 1; set <= this->SetCount; ++set)
  {
    const std::string field = " of lamp set " + std::to_string(set);
    const int lamps = this->Text.readLineCount("number of lamps" + field, -10000, 10000);
    this->Text.readLine("lamp type" + field);
    const double lumens = this->Text.readLineNumber("luminous flux" + field);
    const int fluxLine = this->Text.line();
    this->Text.readLine("colour temperature" + field);
    this->Text.readLine("colour rendering" + field);
    this->Text.readLine("wattage" + field);
    if (!(lumens >= 0 && lumens < 1e12))
      throw PhotometryError(fluxLine, "luminous flux" + field,
                            "found " + shortNumber(lumens) + "; expected lumens of 0 or more");
    if (set != this->Options.lampSet)
      continue;
    if (!(lumens > 0))
      throw PhotometryError(fluxLine, "luminous flux" + field,
                            "found 0, and intensities are per 1000 lm of it; expected lumens above 0");
    flux = lumens;
    this->Absolute = lamps < 0;
    if (this->Absolute)
      this->Warnings.push_back({"ldt-negative-lamps", fluxLine, "number of lamps" + field,
                                "negative: absolute photometry, the flux is that of the luminaire"});
  }
  return flux;
}

PhotometryRows EulumdatReader::readRows()
{
  PhotometryRows rows;
  const std::vector<double> planes = this->Text.readNumbers("angle C", this->PlaneCount);
  checkOrder(planes, this->Text.line(), "angle C", false);
  if (!(planes.front() >= 0 && planes.back() <= 360))
    this->Text.fail("angle C", "expected degrees from 0 to 360");
  rows.angles = this->Text.readNumbers("angle G", this->AngleCount);
  checkOrder(rows.angles, this->Text.line(), "angle G", false);
  if (!(rows.angles.front() >= 0 && rows.angles.back() <= 180))
    this->Text.fail("angle G", "expected degrees from 0 to 180");

  // The planes that the symmetry leaves in the file: all, one, C0 to C180, C270 over C0 to C90, C0 to C90.
  auto addPlane = [&](double plane) {
    rows.planes.push_back(plane);
    rows.candela.push_back(this->Text.readNumbers("candela of plane C" + shortNumber(plane), rows.angles.size()));
  };
  auto inFile = [this](double plane) {
    return this->Symmetry == 0 || (this->Symmetry == 2 && plane <= 180) || (this->Symmetry == 4 && plane <= 90);
  };
  if (this->Symmetry == 1)
    addPlane(0);
  else if (this->Symmetry == 3)
  {
    for (double plane : planes)
      if (plane >= 270 && plane < 360)
        addPlane(plane - 360);
    for (double plane : planes)
      if (plane <= 90)
        addPlane(plane);
  }
  else
    for (double plane : planes)
      if (inFile(plane))
        addPlane(plane);
  checkCandela(rows, this->Text.line());
  return rows;
}

void EulumdatReader::complete(PhotometryRows& rows)
{
  const double low = this->Symmetry == 3 ? -90 : 0;
  const double high = this->Symmetry == 2 ? 180 : this->Symmetry == 3 || this->Symmetry == 4 ? 90 : 360;
  if (this->Symmetry == 1)
  {
    rows.planes = {0, 360};
    rows.candela.push_back(rows.candela.front());
    return;
  }
  if (rows.planes.empty() || std::abs(rows.planes.front() - low) > degreesClosed ||
      (this->Symmetry != 0 && std::abs(rows.planes.back() - high) > degreesClosed))
    this->Text.fail("angle C", "the planes that symmetry " + std::to_string(this->Symmetry) +
                                   " needs are not all listed; expected " + shortNumber(low) + " to " +
                                   shortNumber(high) + " among them");
  if (this->Symmetry == 0)
  {
    // C360 is C0 again, and mostly left out.
    if (std::abs(rows.planes.back() - 360) < degreesClosed)
      rows.planes.back() = 360;
    else
    {
      rows.planes.push_back(360);
      rows.candela.push_back(rows.candela.front());
    }
    return;
  }
  rows.planes.front() = low;
  rows.planes.back() = high;
  if (this->Symmetry == 4)
    rows.mirrorPlanes(90);
  rows.mirrorPlanes(this->Symmetry == 3 ? 90 : 180);
}

void EulumdatReader::tellSpelling()
{
  if (const int line = this->Text.decimalComma())
    this->Warnings.push_back({"ldt-decimal-comma", line, "number", "a decimal comma; read as a point"});
  if (const int line = this->Text.groupedNumber())
    this->Warnings.push_back({"ldt-digit-groups", line, "number", "a blank between digits; read as one number"});
  if (const int line = this->Text.blankNumber())
    this->Warnings.push_back({"ldt-blank", line, "number", "a blank line; taken as 0"});
}

PhotometricFile EulumdatReader::read()
{
  this->Text.readLine("company");
  this->Text.readLineCount("type indicator", 0, 3);
  this->Symmetry = this->Text.readLineCount("symmetry", 0, 4);
  this->PlaneCount = this->Text.readLineCount("number of C planes", 1, maxAngles);
  this->Text.readLineNumber("distance between C planes", 0.0);
  this->AngleCount = this->Text.readLineCount("number of angles G", 2, maxAngles);
  this->Text.readLineNumber("distance between angles G", 0.0);
  this->Text.readLine("report number");
  const std::string name = this->Text.readLine("luminaire name");
  for (const char* field : {"luminaire number", "file name", "date"})
    this->Text.readLine(field);
  for (const char* field : {"length of the luminaire", "width of the luminaire", "height of the luminaire"})
    this->size(field);
  const Opening opening = this->readOpening();
  this->Text.readLineNumber("downward flux fraction", 0.0);
  const double ratio = this->Text.readLineNumber("light output ratio", 0.0);
  const int ratioLine = this->Text.line();
  const double factor = this->Text.readLineNumber("conversion factor");
  if (!(factor > 0 && factor < 1e9))
    this->Text.fail("conversion factor", "found " + shortNumber(factor) + "; expected a factor above 0");
  this->Text.readLineNumber("tilt during measurement", 0.0);
  const double lampFlux = this->readLampSets();
  for (int i = 0; i < 10; ++i)
    this->Text.readLineNumber("direct ratio", 0.0);

  PhotometryRows rows = this->readRows();
  const int lastLine = this->Text.line();
  rows.scale(factor * lampFlux / 1000);
  this->complete(rows);
  if (!this->Text.onlyBlanksLeft())
    this->warn("ldt-trailing", "candela", "more text follows the last intensity; passed over");

  PhotometricFile file{"EULUMDAT", name.substr(0, 80), rows.table(CandelaTable::Pole::Axis)};
  file.lampFlux = this->Absolute ? 0 : lampFlux;
  file.statedFlux = ratio > 0 ? lampFlux * factor * ratio / 100 : 0;
  file.opening = opening;
  file.lampSets = this->SetCount;
  if (file.statedFlux > 0 && std::abs(file.table.flux() - file.statedFlux) > 0.03 * file.statedFlux)
    this->Warnings.push_back({"ldt-light-output-ratio", ratioLine, "light output ratio",
                              shortNumber(ratio) + " %, but the intensities make " +
                                  shortNumber(std::round(10 * 100 * file.table.flux() / (lampFlux * factor)) / 10) +
                                  " %; the intensities are used"});
  if (file.lampFlux > 0 && file.table.flux() > 1.01 * lampFlux * factor)
    this->Warnings.push_back({"ldt-flux", lastLine, "candela", "the intensities make more light than the lamps"});
  this->tellSpelling();
  file.warnings = this->Warnings;
  return file;
}
}  // namespace

PhotometricFile parseEulumdat(const std::string& text, const PhotometryOptions& options)
{
  return EulumdatReader(text, options).read();
}
}  // namespace kalos
