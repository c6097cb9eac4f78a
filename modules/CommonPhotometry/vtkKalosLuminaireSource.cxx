// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosLuminaireSource.h"

#include <cmath>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosCandelaText.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace
{
bool allFinite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/** The half-planes C = 0 and C = 90 deg of an axis: see the class documentation. */
void planesOfAxis(const double axis[3], double rotationDegrees, double along[3], double up[3])
{
  const double y[3] = {0.0, 1.0, 0.0};
  const double z[3] = {0.0, 0.0, 1.0};
  const bool alongY = std::hypot(axis[0], axis[2]) < 0.01;
  const double* reference = alongY ? z : y;
  double zero[3];  // the half-plane C = 0 completes (zero, up, -axis) to a right-handed frame
  vtkMath::Cross(axis, reference, zero);
  vtkMath::Normalize(zero);
  double ninety[3];
  vtkMath::Cross(zero, axis, ninety);
  const double angle = vtkMath::RadiansFromDegrees(rotationDegrees);
  for (int c = 0; c < 3; ++c)
  {
    up[c] = std::cos(angle) * ninety[c] - std::sin(angle) * zero[c];
    along[c] = std::cos(angle) * zero[c] + std::sin(angle) * ninety[c];
  }
}

void setFieldArray(vtkPolyData* data, vtkDataArray* array, const char* name)
{
  array->SetName(name);
  data->GetFieldData()->AddArray(array);
}

void addVector(vtkPointData* data, const char* name, const double v[3])
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(v);
  data->AddArray(array);
}
/** The candela table, which may be null, in the point data and in the field data. */
void addTables(vtkPolyData* output, vtkDoubleArray* tuples, bool sidePole)
{
  vtkNew<vtkStringArray> texts;
  texts->SetName(vtkKalosArrayNames::CandelaTables);
  texts->InsertNextValue(tuples ? vtkKalosCandelaText::Write(tuples, sidePole) : std::string());
  output->GetPointData()->AddArray(texts);
  if (!tuples)
  {
    return;
  }
  vtkNew<vtkDoubleArray> table;
  table->ShallowCopy(tuples);
  setFieldArray(output, table, (std::string(vtkKalosArrayNames::CandelaTable) + "0").c_str());
  vtkNew<vtkIntArray> poles;
  poles->InsertNextValue(sidePole ? 1 : 0);
  setFieldArray(output, poles, vtkKalosArrayNames::CandelaPoles);
}
}  // namespace

vtkStandardNewMacro(vtkKalosLuminaireSource);

vtkKalosLuminaireSource::vtkKalosLuminaireSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkKalosLuminaireSource::SetCandelaTable(vtkDoubleArray* tuples, bool sidePole)
{
  this->CandelaTable = tuples;
  this->SidePole = sidePole;
  this->Distribution = MEASURED;
  this->Modified();
}

std::string vtkKalosLuminaireSource::Check() const
{
  if (!allFinite(this->Position))
  {
    return "the position is not finite; expected three numbers in metres";
  }
  if (!allFinite(this->Aim) || vtkMath::Norm(this->Aim) == 0.0)
  {
    return "the aim is zero or not finite; expected a direction";
  }
  if (!std::isfinite(this->RotationDegrees))
  {
    return "the rotation is not finite; expected degrees";
  }
  if (!std::isfinite(this->Flux) || this->Flux < 0.0)
  {
    return "the luminous flux is negative or not finite; expected at least 0 lm";
  }
  if (this->Shape == POINT)
  {
    if (this->Distribution == MEASURED && (!this->CandelaTable || this->CandelaTable->GetNumberOfComponents() != 3))
    {
      return "the candela table is missing; expected tuples of plane, angle and candela";
    }
    const double sides[2] = {this->OpeningAlongC0, this->OpeningAlongC90};
    if (!(sides[0] >= 0.0 && sides[1] >= 0.0 && std::isfinite(sides[0] + sides[1])))
    {
      return "a side of the luminous opening is negative or not finite; expected at least 0 m";
    }
    return {};
  }
  double normal[3];
  vtkMath::Cross(this->SideU, this->SideV, normal);
  const double sides = vtkMath::Norm(this->SideU) * vtkMath::Norm(this->SideV);
  if (!allFinite(this->SideU) || !allFinite(this->SideV) || !(vtkMath::Norm(normal) > 1e-12 * sides))
  {
    return "the luminous rectangle has no area; expected two finite sides that are neither zero nor parallel";
  }
  const double cosine = vtkMath::Dot(normal, this->Aim) / (vtkMath::Norm(normal) * vtkMath::Norm(this->Aim));
  if (!(std::fabs(cosine) > 1.0 - 1e-6))
  {
    return "the aim is not perpendicular to the luminous rectangle; expected u x v or its opposite";
  }
  if (std::fabs(vtkMath::Dot(this->SideU, this->SideV)) > 1e-6 * sides)
  {
    return "the sides of the luminous rectangle are not perpendicular to each other; expected a rectangle";
  }
  return {};
}

int vtkKalosLuminaireSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string problem = this->Check();
  if (!problem.empty())
  {
    vtkErrorMacro("luminaire '" << this->Name << "': " << problem);
    return 0;
  }

  const bool rectangle = this->Shape == RECTANGLE;
  const double none[3] = {0.0, 0.0, 0.0};
  double direction[3] = {this->Aim[0], this->Aim[1], this->Aim[2]};
  vtkMath::Normalize(direction);
  double along[3];
  double up[3];
  planesOfAxis(direction, this->RotationDegrees, along, up);
  const bool measured = !rectangle && this->Distribution == MEASURED;
  const bool opening = measured && this->OpeningAlongC0 > 0.0 && this->OpeningAlongC90 > 0.0;
  double openingU[3];
  double openingV[3];
  for (int c = 0; c < 3; ++c)
  {
    openingU[c] = this->OpeningAlongC0 * along[c];
    openingV[c] = this->OpeningAlongC90 * up[c];
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType id = points->InsertNextPoint(this->Position);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, &id);

  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  vtkNew<vtkDoubleArray> flux;
  flux->SetName(vtkKalosArrayNames::LuminousFlux);
  flux->InsertNextValue(this->Flux);
  data->AddArray(flux);
  addVector(data, vtkKalosArrayNames::Direction, direction);
  addVector(data, vtkKalosArrayNames::Up, up);
  vtkNew<vtkIntArray> distribution;
  distribution->SetName(vtkKalosArrayNames::Distribution);
  distribution->InsertNextValue(rectangle ? LAMBERTIAN : this->Distribution);
  data->AddArray(distribution);
  addVector(data, vtkKalosArrayNames::SideU, rectangle ? this->SideU : opening ? openingU : none);
  addVector(data, vtkKalosArrayNames::SideV, rectangle ? this->SideV : opening ? openingV : none);
  vtkNew<vtkStringArray> names;
  names->SetName(vtkKalosArrayNames::LuminaireNames);
  names->InsertNextValue(this->Name);
  data->AddArray(names);
  addTables(output, measured ? this->CandelaTable.Get() : nullptr, this->SidePole);
  return 1;
}

void vtkKalosLuminaireSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n";
  os << indent << "Shape: " << (this->Shape == POINT ? "point" : "rectangle") << "\n";
  os << indent << "Position: " << this->Position[0] << " " << this->Position[1] << " " << this->Position[2] << " m\n";
  os << indent << "Aim: " << this->Aim[0] << " " << this->Aim[1] << " " << this->Aim[2] << "\n";
  os << indent << "RotationDegrees: " << this->RotationDegrees << "\n";
  os << indent << "Flux: " << this->Flux << " lm\n";
  const char* const names[] = {"isotropic", "Lambertian", "measured"};
  os << indent << "Distribution: " << names[this->Distribution] << "\n";
  os << indent << "SideU: " << this->SideU[0] << " " << this->SideU[1] << " " << this->SideU[2] << " m\n";
  os << indent << "SideV: " << this->SideV[0] << " " << this->SideV[1] << " " << this->SideV[2] << " m\n";
  os << indent << "OpeningAlongC0: " << this->OpeningAlongC0 << " m\n";
  os << indent << "OpeningAlongC90: " << this->OpeningAlongC90 << " m\n";
}
