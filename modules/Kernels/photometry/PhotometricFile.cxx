// SPDX-License-Identifier: BSD-3-Clause
#include "photometry/PhotometricFile.h"

#include "photometry/PhotometryText.h"

namespace kalos
{
std::string PhotometryWarning::message() const
{
  return "line " + std::to_string(this->line) + ": " + this->field + ": " + this->text + " [" + this->code + "]";
}

PhotometryError::PhotometryError(int line, const std::string& field, const std::string& what)
    : std::runtime_error("line " + std::to_string(line) + ": " + field + ": " + what)
{
}

double PhotometricFile::tiltFactor(double degrees) const
{
  if (this->tiltAngles.empty())
    return 1;
  if (degrees <= this->tiltAngles.front())
    return this->tiltFactors.front();
  for (std::size_t i = 1; i < this->tiltAngles.size(); ++i)
    if (degrees <= this->tiltAngles[i])
    {
      const double t = (degrees - this->tiltAngles[i - 1]) / (this->tiltAngles[i] - this->tiltAngles[i - 1]);
      return (1 - t) * this->tiltFactors[i - 1] + t * this->tiltFactors[i];
    }
  return this->tiltFactors.back();
}

PhotometricFile parsePhotometry(const std::string& text, const PhotometryOptions& options)
{
  const PhotometryText lines(text);
  for (int i = 0; i < lines.size(); ++i)
    if (isTiltLine(lines.peek(i)))
      return parseIes(text, options);
  if (isIesHeader(upperCase(lines.peek(0))))
    throw PhotometryError(lines.size(), "TILT", "the file ends before it; expected a line TILT=");
  return parseEulumdat(text, options);
}
}  // namespace kalos
