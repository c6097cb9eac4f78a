// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSurfaceAlgorithm.h"

#include "MeshConversion.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkKalosSurfaceAlgorithm::vtkKalosSurfaceAlgorithm()
{
  this->SetNumberOfOutputPorts(2);
}

vtkTable* vtkKalosSurfaceAlgorithm::GetReport()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkKalosSurfaceAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkKalosSurfaceAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  vtkTable* report = vtkTable::GetData(outputs, 1);
  return kalos::guarded(this, {output, report}, [&] {
    kalos::checkTimeLimit(this->TimeLimit);
    kalos::ConvertedMesh converted = kalos::convertMesh(input);
    this->Work(input, converted, output, report);
  });
}

void vtkKalosSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
}
