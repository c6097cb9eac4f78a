// SPDX-License-Identifier: BSD-3-Clause
#include "Preview.h"

#include <algorithm>

#include "DataSets.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkKalosArrayNames.h"
#include "vtkMath.h"
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

vtkSmartPointer<vtkPolyData> spreadSet(vtkPolyData* solved, vtkPolyData* receivers)
{
  vtkNew<vtkPoints> centres;
  centres->SetDataTypeToDouble();
  double at[3];
  for (vtkIdType i = 0; i < solved->GetNumberOfCells(); ++i)
  {
    centre(solved, i, at);
    centres->InsertNextPoint(at);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(centres);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(places);
  locator->BuildLocator();

  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->CopyStructure(receivers);
  result->GetCellData()->CopyAllocate(solved->GetCellData(), receivers->GetNumberOfCells());
  vtkDataArray *from = solved->GetCellData()->GetNormals(), *to = receivers->GetCellData()->GetNormals();
  vtkNew<vtkIdList> near;
  for (vtkIdType i = 0; i < receivers->GetNumberOfCells(); ++i)
  {
    centre(receivers, i, at);
    locator->FindClosestNPoints(8, at, near);
    vtkIdType best = near->GetId(0);
    for (vtkIdType k = near->GetNumberOfIds() - 1; k >= 0; --k)
    {
      double a[3], b[3];
      from->GetTuple(near->GetId(k), a);
      to->GetTuple(i, b);
      best = vtkMath::Dot(a, b) > 0.5 ? near->GetId(k) : best;
    }
    result->GetCellData()->CopyData(solved->GetCellData(), best, i);
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
