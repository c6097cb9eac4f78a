// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosPhotometryReader.h"

#include <cmath>
#include <optional>

#include "base/ErrorCatcher.h"
#include "base/InputError.h"
#include "photometric/PhotometricData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosLuminaireSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

struct vtkKalosPhotometryReader::Internals
{
  std::optional<kalos::PhotometricFile> file;

  const kalos::PhotometryWarning* warning(int index) const
  {
    const bool known = this->file && index >= 0 && index < static_cast<int>(this->file->warnings.size());
    return known ? &this->file->warnings[index] : nullptr;
  }
};

namespace
{
/** The luminaire's two sides span its opening; a round one counts as the square of its area. */
void setOpening(vtkKalosLuminaireSource* source, const kalos::Opening& opening)
{
  const double scale = opening.round ? std::sqrt(vtkMath::Pi()) / 2.0 : 1.0;
  source->SetOpeningAlongC0(opening.isPoint() ? 0.0 : scale * opening.alongC0);
  source->SetOpeningAlongC90(opening.isPoint() ? 0.0 : scale * opening.alongC90);
}

/** Tuples (plane, angle, candela), plane by plane. */
vtkSmartPointer<vtkDoubleArray> packTable(const kalos::CandelaTable& table)
{
  auto packed = vtkSmartPointer<vtkDoubleArray>::New();
  packed->SetNumberOfComponents(3);
  for (std::size_t p = 0; p < table.planes().size(); ++p)
  {
    for (std::size_t a = 0; a < table.angles().size(); ++a)
    {
      packed->InsertNextTuple3(table.planes()[p], table.angles()[a], table.candela()[p * table.angles().size() + a]);
    }
  }
  return packed;
}
}  // namespace

vtkStandardNewMacro(vtkKalosPhotometryReader);

vtkKalosPhotometryReader::vtkKalosPhotometryReader() : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(4);
}

vtkKalosPhotometryReader::~vtkKalosPhotometryReader()
{
  this->SetFileName(nullptr);
}

int vtkKalosPhotometryReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkKalosPhotometryReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->Internal->file.reset();
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("photometry: FileName: not set; expected the path of a photometric file");
    return 0;
  }
  try
  {
    this->Internal->file = kalos::photometric::readFile(this->FileName, this->LampSet);
  }
  catch (const kalos::PhotometryError& error)
  {
    vtkErrorMacro(<< kalos::scene::oneLine(std::string(this->FileName) + ": " + error.what()));
    return 0;
  }
  const kalos::PhotometricFile& file = *this->Internal->file;

  const double length = vtkMath::Norm(this->Aim);
  const double down = length > 0.0 ? -this->Aim[2] / length : 1.0;
  const double tilt = vtkMath::DegreesFromRadians(std::acos(std::min(1.0, std::max(-1.0, down))));
  vtkNew<vtkKalosLuminaireSource> source;
  source->SetName(this->Name);
  source->SetPosition(this->Position);
  source->SetAim(this->Aim);
  source->SetRotationDegrees(this->RotationDegrees);
  source->SetFlux(this->Flux != 0.0 ? this->Flux : file.table.flux() * file.tiltFactor(tilt));
  source->SetCandelaTable(packTable(file.table), file.table.pole() == kalos::CandelaTable::Pole::Side);
  setOpening(source, file.opening);
  kalos::scene::ErrorCatcher errors(source);
  source->Update();
  if (!errors.empty())
  {
    this->Internal->file.reset();
    vtkErrorMacro(<< this->FileName << ": " << errors.firstLine());
    return 0;
  }
  for (const kalos::PhotometryWarning& warning : file.warnings)
  {
    vtkWarningMacro(<< this->FileName << ": " << warning.message());
  }
  kalos::photometric::fillSolid(file.table, vtkPolyData::GetData(outputVector, 0));
  kalos::photometric::fillTable(file.table, vtkTable::GetData(outputVector, 1));
  kalos::photometric::fillPolarCurves(file.table, vtkPolyData::GetData(outputVector, 2));
  vtkPolyData::GetData(outputVector, 3)->ShallowCopy(source->GetOutput());
  return 1;
}

int vtkKalosPhotometryReader::CanReadFile(const char* path)
{
  try
  {
    kalos::photometric::readFile(path ? path : "", 1);
    return 1;
  }
  catch (const kalos::PhotometryError&)
  {
    return 0;
  }
}

std::string vtkKalosPhotometryReader::GetFormat() const
{
  return this->Internal->file ? this->Internal->file->format : std::string();
}

std::string vtkKalosPhotometryReader::GetLuminaireName() const
{
  // Latin-1 is common in these files; VTK's strings are UTF-8.
  return this->Internal->file ? kalos::scene::quotable(this->Internal->file->name) : std::string();
}

double vtkKalosPhotometryReader::GetLampFlux() const
{
  return this->Internal->file ? this->Internal->file->lampFlux : 0.0;
}

double vtkKalosPhotometryReader::GetTableFlux() const
{
  return this->Internal->file ? this->Internal->file->table.flux() : 0.0;
}

double vtkKalosPhotometryReader::GetLargestIntensity() const
{
  return this->Internal->file ? this->Internal->file->table.largest() : 0.0;
}

double vtkKalosPhotometryReader::GetOpeningAlongC0() const
{
  return this->Internal->file ? this->Internal->file->opening.alongC0 : 0.0;
}

double vtkKalosPhotometryReader::GetOpeningAlongC90() const
{
  return this->Internal->file ? this->Internal->file->opening.alongC90 : 0.0;
}

double vtkKalosPhotometryReader::GetOpeningHeight() const
{
  return this->Internal->file ? this->Internal->file->opening.height : 0.0;
}

bool vtkKalosPhotometryReader::GetOpeningIsRound() const
{
  return this->Internal->file && this->Internal->file->opening.round;
}

int vtkKalosPhotometryReader::GetNumberOfLampSets() const
{
  return this->Internal->file ? this->Internal->file->lampSets : 0;
}

double vtkKalosPhotometryReader::GetIntensity(double c, double gamma) const
{
  return this->Internal->file ? kalos::photometric::intensity(this->Internal->file->table, c, gamma) : 0.0;
}

void vtkKalosPhotometryReader::SampleDirection(double u1, double u2, double angles[2]) const
{
  if (!this->Internal->file)
  {
    return;
  }
  const kalos::Vec3 d = this->Internal->file->table.sample(u1, u2);
  angles[0] = vtkMath::DegreesFromRadians(std::atan2(d.y, d.x));
  angles[1] = vtkMath::DegreesFromRadians(std::atan2(std::hypot(d.x, d.y), d.z));
}

int vtkKalosPhotometryReader::GetNumberOfWarnings() const
{
  return this->Internal->file ? static_cast<int>(this->Internal->file->warnings.size()) : 0;
}

std::string vtkKalosPhotometryReader::GetWarningCode(int index) const
{
  const auto* warning = this->Internal->warning(index);
  return warning ? warning->code : std::string();
}

std::string vtkKalosPhotometryReader::GetWarning(int index) const
{
  const auto* warning = this->Internal->warning(index);
  return warning ? warning->message() : std::string();
}

void vtkKalosPhotometryReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "LampSet: " << this->LampSet << "\n";
  os << indent << "Position: " << this->Position[0] << " " << this->Position[1] << " " << this->Position[2] << " m\n";
  os << indent << "Aim: " << this->Aim[0] << " " << this->Aim[1] << " " << this->Aim[2] << "\n";
  os << indent << "RotationDegrees: " << this->RotationDegrees << "\n";
  os << indent << "Flux: " << this->Flux << " lm\n";
  os << indent << "Name: " << this->Name << "\n";
}
