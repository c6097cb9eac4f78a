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

std::vector<double> wantedLengths(vtkPolyData* input, const std::string& name)
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

void fillReport(const kalos::meshing::RemeshReport& done, double edgeLength, vtkTable* table)
{
  kalos::ReportTable report(table);
  report.add("triangles before", "", static_cast<double>(done.trianglesBefore));
  report.add("triangles after", "", static_cast<double>(done.trianglesAfter));
  report.add("points after", "", static_cast<double>(done.pointsAfter));
  report.add("patches", "", static_cast<double>(done.patches));
  report.add("area before", "m\xC2\xB2", done.areaBefore);
  report.add("area after", "m\xC2\xB2", done.areaAfter);
  report.add("smallest angle", "degrees", DegreesPerRadian * done.minimumAngle);
  report.add("share of triangles with an angle below 20 degrees", "", done.smallAngles);
  report.add("wanted edge length", "m", edgeLength);
  report.add("shortest edge", "m", done.shortest);
  report.add("mean edge", "m", done.mean);
  report.add("longest edge", "m", done.longest);
  for (std::size_t bin = 0; bin < done.histogram.size(); ++bin)
  {
    const std::string from = std::to_string(25 * bin), to = std::to_string(25 * (bin + 1));
    const bool last = bin + 1 == done.histogram.size();
    report.add("edges of " + from + (last ? " % or more" : " to " + to + " %") + " of the wanted length", "",
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
  settings.wanted = wantedLengths(input, this->SizeArrayName);
  if (!this->ResultArrayName.empty())
  {
    if (!(this->ResultChange > 0.0 && std::isfinite(this->ResultChange)))
    {
      throw std::invalid_argument("ResultChange is not allowed; expected a share of the mean above 0");
    }
    const std::vector<double> forResult =
        kalos::lengthsForResult(input, converted.mesh, this->ResultArrayName, this->ResultChange, this->EdgeLength);
    settings.wanted.resize(forResult.size(), this->EdgeLength);
    std::transform(forResult.begin(), forResult.end(), settings.wanted.begin(), settings.wanted.begin(),
                   [](double a, double b) { return std::min(a, b); });
  }
  settings.maximumTriangles = static_cast<std::size_t>(std::max<vtkIdType>(0, this->MaximumTriangles));
  const auto done = kalos::meshing::remesh(converted.mesh, settings, kalos::progressOf(this, this->TimeLimit));
  kalos::fillPolyData(converted.mesh, input, output);
  fillReport(done, this->EdgeLength, table);
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
