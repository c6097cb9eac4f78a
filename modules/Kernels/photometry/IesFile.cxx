// SPDX-License-Identifier: BSD-3-Clause
// IES LM-63-1986, 1991, 1995, 2002 and 2019.
//
// Warnings: ies-version (unknown standard, read as 2002), ies-reversed (angles descend), ies-range (a range that the
// standards do not foresee, and what is taken for it), ies-seam (planes 0 and 360 differ), ies-lamp-lumens (no lumens
// for relative photometry), ies-future-use (a factor where the standard wants 1), ies-flux (more light than the lamps
// give), ies-trailing (text after the last intensity).
#include "photometry/PhotometryTable.h"
#include "photometry/PhotometryText.h"

namespace kalos
{
namespace
{
constexpr double nearAngle = 0.01;  // degrees; printed angles are rounded
constexpr int maxAngles = 100000;

bool near(double a, double b)
{
  return std::abs(a - b) < nearAngle;
}

class IesReader
{
public:
  IesReader(const std::string& text, const PhotometryOptions& options) : Text(text), Options(options) {}
  PhotometricFile read();

private:
  void warn(const char* code, const std::string& field, const std::string& text)
  {
    this->Warnings.push_back({code, this->Text.line(), field, text});
  }
  void readKeywords();
  void readTilt(const std::string& line);
  void readTiltTable(PhotometryText& text);
  void readAngles(PhotometryRows& rows);
  void readCandela(PhotometryRows& rows, bool transposed);
  void completeTypeC(PhotometryRows& rows);
  void completeTypeA(PhotometryRows& rows);
  void completeTypeB(PhotometryRows& rows);
  void checkAngles(const std::vector<double>& angles, const char* field, double low, double high);
  Opening readOpening(double metres);

  PhotometryText Text;
  const PhotometryOptions& Options;
  int Year = 1986;
  std::string Name;
  int VerticalCount = 0, HorizontalCount = 0, AnglesLine = 0;
  std::vector<double> TiltAngles, TiltFactors;
  std::vector<PhotometryWarning> Warnings;
};

void IesReader::readKeywords()
{
  // LM-63-1986 had neither a first line nor keywords: its lines are free text.
  const std::string first = this->Text.peek(0);
  if (first.compare(0, 5, "IESNA") == 0 || first.compare(0, 4, "IES:") == 0)
  {
    this->Text.readLine("version");
    this->Year = 2002;
    bool known = false;
    for (const auto& [ending, year] :
         {std::pair{"91", 1991}, {"1986", 1986}, {"1991", 1991}, {"1995", 1995}, {"2002", 2002}, {"2019", 2019}})
    {
      const std::string end(ending);
      if (first.size() >= end.size() && first.compare(first.size() - end.size(), end.size(), end) == 0)
      {
        this->Year = year;
        known = true;
      }
    }
    if (!known)
      this->warn("ies-version", "version", "an LM-63 of no known year; read as LM-63-2002");
  }
  for (;;)
  {
    const std::string line = this->Text.readLine("TILT");
    if (isTiltLine(line))
      return this->readTilt(line.substr(line.find('=') + 1));
    for (const char* key : {"[LUMINAIRE]", "[LUMCAT]"})
      if (this->Name.empty() && line.compare(0, std::string(key).size(), key) == 0)
      {
        const auto begin = line.find_first_not_of(" \t", std::string(key).size());
        this->Name = begin == std::string::npos ? "" : line.substr(begin, 80);
      }
  }
}

void IesReader::readTilt(const std::string& value)
{
  const auto begin = value.find_first_not_of(" \t");
  const std::string name = begin == std::string::npos ? "" : value.substr(begin);
  if (name == "NONE")
    return;
  if (name == "INCLUDE")
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
  // Negative sizes mark round shapes: LM-63-2002, table 1; one negative size alone is a circle of LM-63-1995.
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
  return opening;
}

void IesReader::checkAngles(const std::vector<double>& angles, const char* field, double low, double high)
{
  checkOrder(angles, this->Text.line(), field, true);
  for (double angle : {angles.front(), angles.back()})
    if (!(angle >= low - nearAngle && angle <= high + nearAngle))
      this->Text.fail(field, "found " + shortNumber(angle) + "; expected degrees from " + shortNumber(low) + " to " +
                                 shortNumber(high));
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

void snap(std::vector<double>& angles, std::initializer_list<double> ends)
{
  for (double end : ends)
    for (double* angle : {&angles.front(), &angles.back()})
      if (near(*angle, end))
        *angle = end;
}

void IesReader::completeTypeC(PhotometryRows& rows)
{
  this->checkAngles(rows.angles, "vertical angle", 0, 180);
  this->checkAngles(rows.planes, "horizontal angle", -360, 360);
  snap(rows.angles, {0, 90, 180});
  snap(rows.planes, {-360, -180, -90, 0, 90, 180, 270, 360});
  const double low = rows.angles.front(), high = rows.angles.back();
  if ((low != 0 && low != 90) || (high != 90 && high != 180))
    this->warn("ies-range", "vertical angle",
               "from " + shortNumber(low) + " to " + shortNumber(high) + "; taken as dark outside that");
  const double first = rows.planes.front(), last = rows.planes.back(), span = last - first;
  if (rows.planes.size() == 1)
  {
    if (first != 0)
      this->warn("ies-range", "horizontal angle", "a single one of " + shortNumber(first) + "; taken for every plane");
    rows.planes = {0, 360};
    rows.candela.push_back(rows.candela.front());
  }
  else if (first == 0 && last == 90)
  {
    rows.mirrorPlanes(90);
    rows.mirrorPlanes(180);
  }
  else if (span == 180 && std::fmod(first, 90) == 0)
    rows.mirrorPlanes(last);
  else if (span == 360)
  {
    if (rows.candela.front() != rows.candela.back())
      this->warn("ies-seam", "horizontal angle", "the first and the last plane are one, with different intensities");
  }
  else
  {
    double step = 0;
    for (std::size_t p = 1; p < rows.planes.size(); ++p)
      step = std::max(step, rows.planes[p] - rows.planes[p - 1]);
    if (!(span > 180 && span < 360 && 360 - span < 1.5 * step))
      throw PhotometryError(this->AnglesLine, "horizontal angle",
                            "from " + shortNumber(first) + " to " + shortNumber(last) +
                                "; expected 0 alone, 0 to 90, 0 to 180, 90 to 270 or 0 to 360");
    this->warn("ies-range", "horizontal angle",
               "the last one, " + shortNumber(first + 360) + ", is missing; taken as " + shortNumber(first));
    rows.planes.push_back(first + 360);
    rows.candela.push_back(rows.candela.front());
  }
}

void IesReader::completeTypeA(PhotometryRows& rows)
{
  this->checkAngles(rows.angles, "vertical angle", -90, 90);
  this->checkAngles(rows.planes, "horizontal angle", -90, 90);
  snap(rows.angles, {-90, 0, 90});
  snap(rows.planes, {-90, 0, 90});
  if (rows.planes.front() == 0)
    rows.mirrorPlanes(0);
  for (double& angle : rows.angles)
    angle += 90;
}

void IesReader::completeTypeB(PhotometryRows& rows)
{
  this->checkAngles(rows.planes, "vertical angle", -90, 90);
  this->checkAngles(rows.angles, "horizontal angle", -90, 90);
  snap(rows.planes, {-90, 0, 90});
  snap(rows.angles, {-90, 0, 90});
  if (rows.angles.front() == 0)
    rows.mirrorAngles();
  for (double& angle : rows.angles)
    angle = 90 - angle;
  rows.makeAscending();
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
  type == 1 ? this->completeTypeC(rows) : type == 2 ? this->completeTypeB(rows) : this->completeTypeA(rows);
  if (!this->Text.onlyBlanksLeft())
    this->warn("ies-trailing", "candela", "more text follows the last intensity; passed over");

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

PhotometricFile parseIes(const std::string& text, const PhotometryOptions& options)
{
  return IesReader(text, options).read();
}
}  // namespace kalos
