// SPDX-License-Identifier: BSD-3-Clause
#include "ReceiverDistances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "singular/EdgeDistance.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkKalosSingularEdges.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace kalos
{
namespace
{
constexpr double DegreesPerRadian = 180.0 / 3.14159265358979323846;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** The curves at which the kernel is singular. */
kalos::meshing::Curves severe(const kalos::meshing::Curves& curves)
{
  kalos::meshing::Curves severe;
  severe.points = curves.points;
  severe.indices = curves.indices;
  std::copy_if(curves.curves.begin(), curves.curves.end(), std::back_inserter(severe.curves),
               [](const kalos::meshing::Curve& c) { return c.edge.severity > 0.0; });
  return severe;
}

/** Attach distance and angle to a data set's points, or to its cells where only these have normals. */
void attachDistances(const kalos::meshing::EdgeDistance& tree, const kalos::meshing::Curves& curves, bool bothSides,
                     vtkDataSet* receivers)
{
  const bool cells = !receivers->GetPointData()->GetNormals() && receivers->GetCellData()->GetNormals();
  const vtkIdType count = cells ? receivers->GetNumberOfCells() : receivers->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> distance, angle;
  distance->SetName(vtkKalosSingularEdges::EdgeDistanceArrayName());
  angle->SetName(vtkKalosSingularEdges::EdgeAngleArrayName());
  distance->SetNumberOfTuples(count);
  angle->SetNumberOfTuples(count);
  std::vector<double> weights(static_cast<std::size_t>(std::max(1, receivers->GetMaxCellSize())));
  for (vtkIdType i = 0; i < count; ++i)
  {
    kalos::meshing::Point place{0, 0, 0};
    if (cells)
    {
      vtkCell* cell = receivers->GetCell(i);
      double centre[3];
      int part = cell->GetParametricCenter(centre);
      cell->EvaluateLocation(part, centre, place.data(), weights.data());
    }
    else
    {
      receivers->GetPoint(i, place.data());
    }
    const auto nearest = tree.nearest(place);
    distance->SetValue(i, nearest.distance);
    if (std::isfinite(nearest.distance))
    {
      const auto& edge = curves.curves[nearest.curve].edge;
      angle->SetValue(i, toDegrees(bothSides ? std::min(edge.front, edge.back) : edge.front));
    }
    else
    {
      angle->SetValue(i, NotANumber);
    }
  }
  vtkDataSetAttributes* data = cells ? static_cast<vtkDataSetAttributes*>(receivers->GetCellData())
                                     : static_cast<vtkDataSetAttributes*>(receivers->GetPointData());
  data->AddArray(distance);
  data->AddArray(angle);
}
}  // namespace

double toDegrees(double radians)
{
  return std::isfinite(radians) ? DegreesPerRadian * radians : NotANumber;
}

void copyReceivers(vtkDataObject* input, vtkDataObject* output)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input);
  if (!blocks)
  {
    output->ShallowCopy(input);
    return;
  }
  auto* copies = vtkMultiBlockDataSet::SafeDownCast(output);
  copies->CopyStructure(blocks);
  auto items = vtk::TakeSmartPointer(blocks->NewIterator());
  for (items->InitTraversal(); !items->IsDoneWithTraversal(); items->GoToNextItem())
  {
    auto leaf = vtk::TakeSmartPointer(items->GetCurrentDataObject()->NewInstance());
    leaf->ShallowCopy(items->GetCurrentDataObject());
    copies->SetDataSet(items, leaf);
  }
  copies->GetFieldData()->PassData(blocks->GetFieldData());
}

void attachAllDistances(const kalos::meshing::Curves& all, bool bothSides, vtkDataObject* receivers)
{
  const kalos::meshing::Curves curves = severe(all);
  const kalos::meshing::EdgeDistance tree(curves);
  if (auto* leaf = vtkDataSet::SafeDownCast(receivers))
  {
    attachDistances(tree, curves, bothSides, leaf);
  }
  else if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(receivers))
  {
    auto items = vtk::TakeSmartPointer(blocks->NewIterator());
    for (items->InitTraversal(); !items->IsDoneWithTraversal(); items->GoToNextItem())
    {
      if (auto* block = vtkDataSet::SafeDownCast(items->GetCurrentDataObject()))
      {
        attachDistances(tree, curves, bothSides, block);
      }
    }
  }
}
}  // namespace kalos
