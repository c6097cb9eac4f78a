// SPDX-License-Identifier: BSD-3-Clause
#include "run/Preview.h"

#include <algorithm>
#include <vector>

#include "base/DataSets.h"
#include "scene/Triangles.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
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
        centres->InsertNextPoint(cellCentre(data, i).GetData());
        this->Cells.push_back(i);
      }
    vtkNew<vtkPolyData> places;
    places->SetPoints(centres);
    this->Locator->SetDataSet(places);
    if (!this->Cells.empty())
      this->Locator->BuildLocator();
  }

  /// The nearest cell; 0 if there are none.
  vtkIdType nearest(const Point& at) const
  {
    return this->Cells.empty() ? 0 : this->Cells[this->Locator->FindClosestPoint(at.GetData())];
  }

private:
  std::vector<vtkIdType> Cells;
  vtkNew<vtkStaticPointLocator> Locator;
};

/// For each receiver the cell of `solved` that stands for it.
vtkSmartPointer<vtkIdList> standIns(vtkPolyData* solved, vtkPolyData* receivers)
{
  auto cells = vtkSmartPointer<vtkIdList>::New();
  cells->SetNumberOfIds(receivers->GetNumberOfCells());
  vtkDataArray* normals = receivers->GetCellData()->GetNormals();
  for (int way = 0; way < 6; ++way)
  {
    const Facing some(solved, way);
    for (vtkIdType i = 0; i < receivers->GetNumberOfCells(); ++i)
      if (facing(normals, i) == way)
        cells->SetId(i, some.nearest(cellCentre(receivers, i)));
  }
  return cells;
}

/// The receivers with what `solved` has in addition, taken from the cells that stand for them.
vtkSmartPointer<vtkPolyData> spreadSet(vtkPolyData* solved, vtkPolyData* receivers, vtkIdList* cells)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(receivers);
  vtkCellData *from = solved->GetCellData(), *to = result->GetCellData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (!array || to->HasArray(array->GetName()))
      continue;
    auto all = vtk::TakeSmartPointer(array->NewInstance());
    all->SetName(array->GetName());
    all->SetNumberOfComponents(array->GetNumberOfComponents());
    all->SetNumberOfTuples(cells->GetNumberOfIds());
    array->GetTuples(cells, all);
    to->AddArray(all);
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
      addSet(blocks, set.name, make(set));
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

Spread::Spread(vtkDataObject* some, vtkDataObject* receivers)
{
  const QVector<NamedSet> all = dataSets(receivers);
  for (const NamedSet& set : dataSets(some))
  {
    const auto whole =
        std::find_if(all.begin(), all.end(), [&](const NamedSet& other) { return other.name == set.name; });
    auto* data = vtkPolyData::SafeDownCast(whole->data);
    this->Sets.push_back({data, standIns(vtkPolyData::SafeDownCast(set.data), data)});
  }
}

vtkSmartPointer<vtkDataObject> Spread::over(vtkDataObject* solved) const
{
  auto next = this->Sets.begin();
  auto blocks = transform(solved, [&](const NamedSet& set) {
    const Set& whole = *next++;
    return spreadSet(vtkPolyData::SafeDownCast(set.data), whole.receivers, whole.cells);
  });
  blocks->GetFieldData()->ShallowCopy(solved->GetFieldData());
  return blocks;
}
}  // namespace studio
