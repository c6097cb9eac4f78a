// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosCalculationPlane.h"

#include <cmath>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
bool allFinite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

void fillPoints(vtkPoints* points, const double origin[3], const double u[3], const double v[3], const int n[2])
{
  points->SetNumberOfPoints(static_cast<vtkIdType>(n[0] + 1) * (n[1] + 1));
  vtkIdType id = 0;
  for (int j = 0; j <= n[1]; ++j)
  {
    const double t = static_cast<double>(j) / n[1];
    for (int i = 0; i <= n[0]; ++i)
    {
      const double s = static_cast<double>(i) / n[0];
      points->SetPoint(id++, origin[0] + s * u[0] + t * v[0], origin[1] + s * u[1] + t * v[1],
                       origin[2] + s * u[2] + t * v[2]);
    }
  }
}

void fillQuads(vtkCellArray* quads, const int n[2], bool flip)
{
  quads->AllocateExact(static_cast<vtkIdType>(n[0]) * n[1], 4 * static_cast<vtkIdType>(n[0]) * n[1]);
  const vtkIdType row = n[0] + 1;
  for (int j = 0; j < n[1]; ++j)
  {
    for (int i = 0; i < n[0]; ++i)
    {
      const vtkIdType a = j * row + i;
      const vtkIdType forward[4] = {a, a + 1, a + 1 + row, a + row};
      const vtkIdType backward[4] = {a, a + row, a + 1 + row, a + 1};
      quads->InsertNextCell(4, flip ? backward : forward);
    }
  }
}
}  // namespace

vtkStandardNewMacro(vtkKalosCalculationPlane);

vtkKalosCalculationPlane::vtkKalosCalculationPlane()
{
  this->SetNumberOfInputPorts(0);
}

int vtkKalosCalculationPlane::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const double* u = this->U;
  const double* v = this->V;
  const int* n = this->Resolution;
  if (!allFinite(this->Origin) || !allFinite(u) || !allFinite(v))
  {
    vtkErrorMacro("the calculation plane's Origin, U and V must be finite numbers, in metres");
    return 0;
  }
  if (n[0] < 1 || n[1] < 1 || static_cast<vtkIdType>(n[0]) * n[1] > MaximumNumberOfCells())
  {
    vtkErrorMacro("the calculation plane's resolution is "
                  << n[0] << " x " << n[1] << "; expected at least 1 x 1 and at most " << MaximumNumberOfCells()
                  << " cells");
    return 0;
  }
  double normal[3];
  vtkMath::Cross(u, v, normal);
  const double area = vtkMath::Normalize(normal);
  // Relative, so that a millimetre plane and a stadium are judged alike.
  if (!(area > 1e-12 * vtkMath::Norm(u) * vtkMath::Norm(v)))
  {
    vtkErrorMacro("the calculation plane has no area; expected U and V that are neither zero nor parallel");
    return 0;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  fillPoints(points, this->Origin, u, v, n);
  vtkNew<vtkCellArray> quads;
  fillQuads(quads, n, this->Flip);

  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(quads->GetNumberOfCells());
  const double sign = this->Flip ? -1.0 : 1.0;
  for (int c = 0; c < 3; ++c)
  {
    normals->FillComponent(c, sign * normal[c]);
  }

  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetPolys(quads);
  output->GetCellData()->SetNormals(normals);
  return 1;
}

void vtkKalosCalculationPlane::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2] << " m\n";
  os << indent << "U: " << this->U[0] << " " << this->U[1] << " " << this->U[2] << " m\n";
  os << indent << "V: " << this->V[0] << " " << this->V[1] << " " << this->V[2] << " m\n";
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "Flip: " << (this->Flip ? "on" : "off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
