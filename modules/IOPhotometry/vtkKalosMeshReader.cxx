// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosMeshReader.h"

#include <new>

#include "base/InputError.h"
#include "scene/LooseMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkKalosMeshReader);

vtkKalosMeshReader::vtkKalosMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkKalosMeshReader::~vtkKalosMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkKalosMeshReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("mesh: FileName: not set; expected the path of a mesh file");
    return 0;
  }
  try
  {
    vtkPolyData::GetData(outputVector)->ShallowCopy(kalos::scene::readLooseMesh(this->FileName));
    return 1;
  }
  catch (const kalos::scene::InputError& error)
  {
    vtkErrorMacro(<< error.message(this->FileName));
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< this->FileName << ": file: not enough memory; expected a smaller mesh");
  }
  return 0;
}

void vtkKalosMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
