// SPDX-License-Identifier: BSD-3-Clause
#include "ReceiverConversion.h"

#include <stdexcept>
#include <string>

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayLengths.h"
#include "vtkKalosArrayNames.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// Point data wins over cell data: a surface with smooth normals asks for values at its points.
bool HasPointReceivers(vtkDataSet* dataSet)
{
  return dataSet->GetPointData()->GetNormals() != nullptr;
}

kalos::Vec3 UnitNormal(vtkDataArray* normals, vtkIdType i)
{
  const double* v = normals->GetTuple3(i);
  const kalos::Vec3 n{v[0], v[1], v[2]};
  const double l = kalos::length(n);
  if (!(l > 0 && std::isfinite(l)))
    throw std::invalid_argument("receivers: normal " + std::to_string(i) + " has no direction, expected a unit vector");
  return (1 / l) * n;
}

kalos::Vec3 ToVec3(const double v[3])
{
  return {v[0], v[1], v[2]};
}

void AppendCells(vtkDataSet* dataSet, vtkDataArray* normals, kalos::Receivers& receivers)
{
  for (vtkIdType i = 0; i < dataSet->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = dataSet->GetCell(i);
    std::vector<kalos::Vec3> corners;
    kalos::Vec3 centre;
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      corners.push_back(ToVec3(cell->GetPoints()->GetPoint(k)));
      centre += corners.back();
    }
    if (corners.empty())
      throw std::invalid_argument("receivers: cell " + std::to_string(i) + " has no points");
    receivers.points.push_back((1.0 / static_cast<double>(corners.size())) * centre);
    receivers.normals.push_back(UnitNormal(normals, i));
    receivers.cells.resize(receivers.points.size());
    if (cell->GetCellDimension() == 2)
      receivers.cells.back() = std::move(corners);
  }
}

/// What vtkKalosSingularEdges has found, as the distance from a right-angled edge with the same kernel.
void AppendEdgeDistances(vtkDataSetAttributes* data, vtkIdType count, kalos::Receivers& receivers)
{
  vtkDataArray* distance = data->GetArray(vtkKalosArrayNames::EdgeDistance);
  vtkDataArray* angle = data->GetArray(vtkKalosArrayNames::EdgeAngle);
  if (!distance || !angle || receivers.edgeDistances.size() + count != receivers.points.size())
    return;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double d = distance->GetComponent(i, 0);
    receivers.edgeDistances.push_back(
        std::isfinite(d) ? d * std::tan(vtkMath::RadiansFromDegrees(angle->GetComponent(i, 0)) / 2) : d);
  }
}

void AddColumn(vtkDataSetAttributes* data, const char* name, const std::vector<double>& values, std::size_t first,
               vtkIdType count, int components = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first * components), count * components,
              array->GetPointer(0));
  data->AddArray(array);
}

void AddFlags(vtkDataSetAttributes* data, const char* name, const std::vector<char>& flags, std::size_t first,
              vtkIdType count)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  std::copy_n(flags.begin() + static_cast<std::ptrdiff_t>(first), count, array->GetPointer(0));
  data->AddArray(array);
}

std::vector<double> Scaled(std::vector<double> values, double factor)
{
  for (double& value : values)
    value *= factor;
  return values;
}
}  // namespace

void AppendReceivers(vtkDataSet* dataSet, kalos::Receivers& receivers)
{
  if (HasPointReceivers(dataSet))
  {
    vtkKalosArrayLengths::Require(dataSet->GetPointData(), dataSet->GetNumberOfPoints(), "receiver points");
    vtkDataArray* normals = dataSet->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < dataSet->GetNumberOfPoints(); ++i)
    {
      receivers.points.push_back(ToVec3(dataSet->GetPoint(i)));
      receivers.normals.push_back(UnitNormal(normals, i));
    }
    receivers.cells.resize(receivers.points.size());
    AppendEdgeDistances(dataSet->GetPointData(), dataSet->GetNumberOfPoints(), receivers);
  }
  else if (vtkDataArray* normals = dataSet->GetCellData()->GetNormals())
  {
    vtkKalosArrayLengths::Require(dataSet->GetCellData(), dataSet->GetNumberOfCells(), "receiver cells");
    AppendCells(dataSet, normals, receivers);
    AppendEdgeDistances(dataSet->GetCellData(), dataSet->GetNumberOfCells(), receivers);
  }
  else
    throw std::invalid_argument("receivers: have no normals, expected point normals or cell normals");
}

std::size_t AttachResults(const kalos::Result& result, const std::vector<char>& valid, std::size_t first,
                          vtkDataSet* dataSet)
{
  namespace Names = vtkKalosArrayNames;
  const bool points = HasPointReceivers(dataSet);
  auto* data = points ? static_cast<vtkDataSetAttributes*>(dataSet->GetPointData()) : dataSet->GetCellData();
  const vtkIdType count = points ? dataSet->GetNumberOfPoints() : dataSet->GetNumberOfCells();
  AddColumn(data, Names::Illuminance, result.illuminance, first, count);
  AddColumn(data, Names::IlluminanceStandardError, result.standardError, first, count);
  AddColumn(data, Names::DirectIlluminance, result.direct, first, count);
  AddColumn(data, Names::IndirectIlluminanceStandardError, result.indirectError, first, count);
  if (!result.replicateIlluminance.empty())
    AddColumn(data, Names::IlluminanceReplicates, result.replicateIlluminance, first, count, result.replicates);
  AddColumn(data, Names::LargestScoreShare, result.largestScoreShare, first, count);
  AddFlags(data, Names::IntervalTrusted, result.trusted, first, count);
  AddFlags(data, Names::Valid, valid, first, count);
  if (!result.gatherRays.empty())
    AddColumn(data, Names::GatherRays, result.gatherRays, first, count);
  if (!result.goal.empty())
    AddFlags(data, Names::GoalStatus, result.goal, first, count);
  if (result.alteredKernel)
    AddColumn(data, Names::KernelCorrection, result.kernelCorrection, first, count);
  if (result.skyIlluminance > 0)
  {
    AddColumn(data, Names::DaylightFactor, Scaled(result.illuminance, 100 / result.skyIlluminance), first, count);
    AddColumn(data, Names::DaylightFactorStandardError, Scaled(result.standardError, 100 / result.skyIlluminance),
              first, count);
  }
  if (result.bands > 1)
    AddColumn(data, Names::IlluminanceBands, result.illuminanceBands, first, count, result.bands);
  data->SetActiveScalars(Names::Illuminance);
  return first + static_cast<std::size_t>(count);
}
