// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSkySource.h"

#include <cmath>
#include <sstream>

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkKalosArrayNames.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkKalosSkySource);

vtkKalosSkySource::vtkKalosSkySource() = default;

vtkKalosSkySource::~vtkKalosSkySource() = default;

void vtkKalosSkySource::SetMap(vtkFloatArray* rows)
{
  this->Map = rows;
  this->Modified();
}

int vtkKalosSkySource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

std::string vtkKalosSkySource::Check() const
{
  std::ostringstream problem;
  const auto refuse = [&problem](const char* name, double value, const char* expected) {
    if (problem.str().empty())
    {
      problem << name << ": is " << value << "; expected " << expected;
    }
  };
  if (this->Model < MAP || this->Model > 16)
  {
    refuse("Model", this->Model, "1 to 16, 0 (Perez) or -1 (map)");
  }
  if (!(this->SunElevationDegrees >= 0.0 && this->SunElevationDegrees <= 90.0))
  {
    refuse("SunElevationDegrees", this->SunElevationDegrees, "0 to 90: the sun must not be below the horizon");
  }
  if (!(this->GroundReflectance >= 0.0 && this->GroundReflectance <= 1.0))
  {
    refuse("GroundReflectance", this->GroundReflectance, "0 to 1");
  }
  const std::pair<const char*, double> finite[] = {{"HorizontalIlluminance", this->HorizontalIlluminance},
                                                   {"ZenithLuminance", this->ZenithLuminance},
                                                   {"SunAzimuthDegrees", this->SunAzimuthDegrees},
                                                   {"SunNormalIlluminance", this->SunNormalIlluminance},
                                                   {"NorthDegrees", this->NorthDegrees}};
  for (const auto& [name, value] : finite)
  {
    if (!std::isfinite(value))
    {
      refuse(name, value, "a finite number");
    }
  }
  const std::pair<const char*, double> irradiances[] = {
      {"DirectNormalIrradiance", this->DirectNormalIrradiance},
      {"DiffuseHorizontalIrradiance", this->DiffuseHorizontalIrradiance}};
  for (const auto& [name, value] : irradiances)
  {
    if (!(value >= 0.0 && std::isfinite(value)))
    {
      refuse(name, value, "W/m2, 0 or more");
    }
  }
  if (this->Model > 0 && this->HorizontalIlluminance < 0.0 && this->ZenithLuminance < 0.0)
  {
    refuse("HorizontalIlluminance", this->HorizontalIlluminance, "lx, or ZenithLuminance instead");
  }
  if (this->Model == MAP && (!this->Map || this->Map->GetNumberOfValues() == 0))
  {
    return "Map: is not set; expected a latitude-longitude picture";
  }
  return problem.str();
}

int vtkKalosSkySource::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const std::string problem = this->Check();
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    output->Initialize();
    return 0;
  }
  if (vtkPolyData* luminaires = vtkPolyData::GetData(inputs[0]))
  {
    output->ShallowCopy(luminaires);
    vtkNew<vtkFieldData> fields;  // of its own: the input stays as it is
    fields->ShallowCopy(luminaires->GetFieldData());
    output->SetFieldData(fields);
  }
  vtkNew<vtkDoubleArray> sky;
  sky->SetName(vtkKalosArrayNames::Sky);
  sky->SetNumberOfComponents(NUMBER_OF_COMPONENTS);
  const double values[NUMBER_OF_COMPONENTS] = {static_cast<double>(this->Model),
                                               this->HorizontalIlluminance,
                                               this->ZenithLuminance,
                                               this->SunElevationDegrees,
                                               this->SunAzimuthDegrees,
                                               this->SunNormalIlluminance,
                                               this->DirectNormalIrradiance,
                                               this->DiffuseHorizontalIrradiance,
                                               this->GroundReflectance,
                                               this->NorthDegrees};
  sky->InsertNextTuple(values);
  output->GetFieldData()->AddArray(sky);
  output->GetFieldData()->RemoveArray(vtkKalosArrayNames::SkyMap);
  if (this->Model == MAP)
  {
    vtkNew<vtkFloatArray> map;
    map->ShallowCopy(this->Map);
    map->SetName(vtkKalosArrayNames::SkyMap);
    output->GetFieldData()->AddArray(map);
  }
  return 1;
}

void vtkKalosSkySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "HorizontalIlluminance: " << this->HorizontalIlluminance << " lx\n";
  os << indent << "ZenithLuminance: " << this->ZenithLuminance << " cd/m2\n";
  os << indent << "SunElevationDegrees: " << this->SunElevationDegrees << "\n";
  os << indent << "SunAzimuthDegrees: " << this->SunAzimuthDegrees << "\n";
  os << indent << "SunNormalIlluminance: " << this->SunNormalIlluminance << " lx\n";
  os << indent << "DirectNormalIrradiance: " << this->DirectNormalIrradiance << " W/m2\n";
  os << indent << "DiffuseHorizontalIrradiance: " << this->DiffuseHorizontalIrradiance << " W/m2\n";
  os << indent << "GroundReflectance: " << this->GroundReflectance << "\n";
  os << indent << "NorthDegrees: " << this->NorthDegrees << "\n";
  os << indent << "Map: " << (this->Map ? "set" : "(none)") << "\n";
}
