// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/IesPlanes.h"

#include <algorithm>
#include <cmath>

#include "photometry/PhotometryText.h"

namespace kalos
{
namespace
{
constexpr double nearAngle = 0.01;  // degrees; printed angles are rounded
bool near(double a, double b)
{
  return std::abs(a - b) < nearAngle;
}

class Completion
{
public:
  Completion(const IesLines& lines, std::vector<PhotometryWarning>& warnings) : Lines(lines), Warnings(warnings) {}
  void completeTypeC(PhotometryRows& rows);
  void completeTypeA(PhotometryRows& rows);
  void completeTypeB(PhotometryRows& rows);

private:
  void warn(const char* code, const std::string& field, const std::string& text)
  {
    this->Warnings.push_back({code, this->Lines.last, field, text});
  }
  void checkAngles(const std::vector<double>& angles, const char* field, double low, double high);

  IesLines Lines;
  std::vector<PhotometryWarning>& Warnings;
};

void Completion::checkAngles(const std::vector<double>& angles, const char* field, double low, double high)
{
  checkOrder(angles, this->Lines.last, field, true);
  for (double angle : {angles.front(), angles.back()})
    if (!(angle >= low - nearAngle && angle <= high + nearAngle))
      throw PhotometryError(
          this->Lines.last, field,
          "found " + shortNumber(angle) + "; expected degrees from " + shortNumber(low) + " to " + shortNumber(high));
}

void snap(std::vector<double>& angles, std::initializer_list<double> ends)
{
  for (double end : ends)
    for (double* angle : {&angles.front(), &angles.back()})
      if (near(*angle, end))
        *angle = end;
}

void Completion::completeTypeC(PhotometryRows& rows)
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
      throw PhotometryError(this->Lines.angles, "horizontal angle",
                            "from " + shortNumber(first) + " to " + shortNumber(last) +
                                "; expected 0 alone, 0 to 90, 0 to 180, 90 to 270 or 0 to 360");
    this->warn("ies-range", "horizontal angle",
               "the last one, " + shortNumber(first + 360) + ", is missing; taken as " + shortNumber(first));
    rows.planes.push_back(first + 360);
    rows.candela.push_back(rows.candela.front());
  }
}

void Completion::completeTypeA(PhotometryRows& rows)
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

void Completion::completeTypeB(PhotometryRows& rows)
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
}  // namespace

void completeIesPlanes(PhotometryRows& rows, int type, const IesLines& lines, std::vector<PhotometryWarning>& warnings)
{
  Completion completion(lines, warnings);
  type == 1   ? completion.completeTypeC(rows)
  : type == 2 ? completion.completeTypeB(rows)
              : completion.completeTypeA(rows);
}
}  // namespace kalos
