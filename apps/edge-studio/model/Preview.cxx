// SPDX-License-Identifier: BSD-3-Clause
#include "Preview.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "DataSets.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

namespace studio
{
namespace
{
bool hasCells(const NamedSet& set)
{
  return vtkPolyData::SafeDownCast(set.data) && set.data->GetCellData()->GetNormals();
}

vtkSmartPointer<vtkPolyData> everyNth(vtkPolyData* data, vtkIdType step)
{
  auto some = vtkSmartPointer<vtkPolyData>::New();
  some->SetPoints(data->GetPoints());
  some->AllocateEstimate(data->GetNumberOfCells() / step + 1, 4);
  some->GetCellData()->CopyAllocate(data->GetCellData());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); i += step)
  {
    data->GetCellPoints(i, corners);
    const vtkIdType added = some->InsertNextCell(data->GetCellType(i), corners);
    some->GetCellData()->CopyData(data->GetCellData(), i, added);
  }
  return some;
}

void centre(vtkPolyData* data, vtkIdType cell, double at[3])
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  std::fill(at, at + 3, 0.0);
  for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
  {
    const double* corner = data->GetPoint(corners->GetId(k));
    for (int i = 0; i < 3; ++i)
      at[i] += corner[i] / static_cast<double>(corners->GetNumberOfIds());
  }
}

/// Which of the six directions of the axes a normal is nearest to.
int facing(vtkDataArray* normals, vtkIdType cell)
{
  double n[3];
  normals->GetTuple(cell, n);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    axis = std::abs(n[i]) > std::abs(n[axis]) ? i : axis;
  return 2 * axis + (n[axis] < 0 ? 1 : 0);
}

/// The cells of a set that face one way, by their centres.
class Facing
{
public:
  Facing(vtkPolyData* data, int way)
  {
    vtkNew<vtkPoints> centres;
    centres->SetDataTypeToDouble();
    vtkDataArray* normals = data->GetCellData()->GetNormals();
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
      if (facing(normals, i) == way)
      {
        double at[3];
        centre(data, i, at);
        centres->InsertNextPoint(at);
        this->Cells.push_back(i);
      }
    vtkNew<vtkPolyData> places;
    places->SetPoints(centres);
    this->Locator->SetDataSet(places);
    if (!this->Cells.empty())
      this->Locator->BuildLocator();
  }

  /// The nearest cell; 0 if there are none.
  vtkIdType nearest(const double at[3]) const
  {
    return this->Cells.empty() ? 0 : this->Cells[this->Locator->FindClosestPoint(at)];
  }

private:
  std::vector<vtkIdType> Cells;
  vtkNew<vtkStaticPointLocator> Locator;
};

vtkSmartPointer<vtkPolyData> spreadSet(vtkPolyData* solved, vtkPolyData* receivers)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->CopyStructure(receivers);
  result->GetCellData()->CopyAllocate(solved->GetCellData(), receivers->GetNumberOfCells());
  vtkDataArray* normals = receivers->GetCellData()->GetNormals();
  for (int way = 0; way < 6; ++way)
  {
    const Facing some(solved, way);
    for (vtkIdType i = 0; i < receivers->GetNumberOfCells(); ++i)
      if (facing(normals, i) == way)
      {
        double at[3];
        centre(receivers, i, at);
        result->GetCellData()->CopyData(solved->GetCellData(), some.nearest(at), i);
      }
  }
  return result;
}

/// A multi-block of what `make` gives for each set that has cells to choose from.
template <class Make>
vtkSmartPointer<vtkMultiBlockDataSet> transform(vtkDataObject* object, const Make& make)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const NamedSet& set : dataSets(object))
    if (hasCells(set))
    {
      const unsigned int at = blocks->GetNumberOfBlocks();
      blocks->SetBlock(at, make(set));
      blocks->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), set.name.toUtf8().constData());
    }
  return blocks;
}
}  // namespace

vtkSmartPointer<vtkDataObject> someReceivers(vtkDataObject* receivers, int wanted)
{
  vtkIdType count = 0;
  for (const NamedSet& set : dataSets(receivers))
    count += hasCells(set) ? set.data->GetNumberOfCells() : 0;
  const vtkIdType step = count / wanted;
  if (step < 3)
    return nullptr;
  return transform(receivers, [&](const NamedSet& set) { return everyNth(vtkPolyData::SafeDownCast(set.data), step); });
}

vtkSmartPointer<vtkDataObject> spread(vtkDataObject* solved, vtkDataObject* receivers)
{
  const QVector<NamedSet> all = dataSets(receivers);
  auto blocks = transform(solved, [&](const NamedSet& set) {
    const auto whole =
        std::find_if(all.begin(), all.end(), [&](const NamedSet& other) { return other.name == set.name; });
    return spreadSet(vtkPolyData::SafeDownCast(set.data), vtkPolyData::SafeDownCast(whole->data));
  });
  blocks->GetFieldData()->ShallowCopy(solved->GetFieldData());
  return blocks;
}
}  // namespace studio
