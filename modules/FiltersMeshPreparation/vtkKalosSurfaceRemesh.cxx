// SPDX-License-Identifier: BSD-3-Clause
#include "vtkKalosSurfaceRemesh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "MeshConversion.h"
#include "ReportTable.h"
#include "ResultLengths.h"
#include "remesh/SurfaceRemesh.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace
{
constexpr double DegreesPerRadian = 180.0 / 3.14159265358979323846;

std::vector<double> WantedLengths(vtkPolyData* input, const std::string& name)
{
  if (name.empty())
  {
    return {};
  }
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("no cell array " + name + " of 1 component; expected lengths in metres");
  }
  std::vector<double> lengths(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    lengths[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return lengths;
}

void FillReport(const kalos::meshing::RemeshReport& done, double edgeLength, vtkTable* table)
{
  kalos::ReportTable report(table);
  report.Add("triangles before", "", static_cast<double>(done.trianglesBefore));
  report.Add("triangles after", "", static_cast<double>(done.trianglesAfter));
  report.Add("points after", "", static_cast<double>(done.pointsAfter));
  report.Add("patches", "", static_cast<double>(done.patches));
  report.Add("area before", "m\xC2\xB2", done.areaBefore);
  report.Add("area after", "m\xC2\xB2", done.areaAfter);
  report.Add("smallest angle", "degrees", DegreesPerRadian * done.minimumAngle);
  report.Add("share of triangles with an angle below 20 degrees", "", done.smallAngles);
  report.Add("wanted edge length", "m", edgeLength);
  report.Add("shortest edge", "m", done.shortest);
  report.Add("mean edge", "m", done.mean);
  report.Add("longest edge", "m", done.longest);
  for (std::size_t bin = 0; bin < done.histogram.size(); ++bin)
  {
    const std::string from = std::to_string(25 * bin), to = std::to_string(25 * (bin + 1));
    const bool last = bin + 1 == done.histogram.size();
    report.Add("edges of " + from + (last ? " % or more" : " to " + to + " %") + " of the wanted length", "",
               static_cast<double>(done.histogram[bin]));
  }
}
}  // namespace

vtkStandardNewMacro(vtkKalosSurfaceRemesh);

void vtkKalosSurfaceRemesh::Work(vtkPolyData* input, kalos::ConvertedMesh& converted, vtkPolyData* output,
                                 vtkTable* table)
{
  if (!(this->FeatureAngle > 0.0 && this->FeatureAngle <= 180.0))
  {
    throw std::invalid_argument("FeatureAngle is not allowed; expected degrees above 0, at most 180");
  }
  kalos::meshing::RemeshSettings settings;
  settings.edgeLength = this->EdgeLength;
  settings.feature = this->FeatureAngle / DegreesPerRadian;
  settings.iterations = this->Iterations;
  settings.smallest = this->SmallestEdgeLength;
  settings.grading = this->Grading;
  settings.wanted = WantedLengths(input, this->SizeArrayName);
  if (!this->ResultArrayName.empty())
  {
    if (!(this->ResultChange > 0.0 && std::isfinite(this->ResultChange)))
    {
      throw std::invalid_argument("ResultChange is not allowed; expected a share of the mean above 0");
    }
    const std::vector<double> forResult =
        kalos::LengthsForResult(input, converted.Mesh, this->ResultArrayName, this->ResultChange, this->EdgeLength);
    settings.wanted.resize(forResult.size(), this->EdgeLength);
    std::transform(forResult.begin(), forResult.end(), settings.wanted.begin(), settings.wanted.begin(),
                   [](double a, double b) { return std::min(a, b); });
  }
  settings.maximumTriangles = static_cast<std::size_t>(std::max<vtkIdType>(0, this->MaximumTriangles));
  const auto done = kalos::meshing::remesh(converted.Mesh, settings, kalos::ProgressOf(this, this->TimeLimit));
  kalos::FillPolyData(converted.Mesh, input, output);
  FillReport(done, this->EdgeLength, table);
}

void vtkKalosSurfaceRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "SmallestEdgeLength: " << this->SmallestEdgeLength << "\n";
  os << indent << "Grading: " << this->Grading << "\n";
  os << indent << "SizeArrayName: " << (this->SizeArrayName.empty() ? "(none)" : this->SizeArrayName) << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName.empty() ? "(none)" : this->ResultArrayName) << "\n";
  os << indent << "ResultChange: " << this->ResultChange << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "MaximumTriangles: " << this->MaximumTriangles << "\n";
}
