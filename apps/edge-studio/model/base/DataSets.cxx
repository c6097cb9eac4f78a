// SPDX-License-Identifier: BSD-3-Clause
#include "base/DataSets.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

namespace studio
{
QVector<NamedSet> dataSets(vtkDataObject* object)
{
  if (auto* single = vtkDataSet::SafeDownCast(object))
    return {{QString(), single}};
  QVector<NamedSet> sets;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(object);
  for (unsigned int i = 0; blocks && i < blocks->GetNumberOfBlocks(); ++i)
    if (auto* data = vtkDataSet::SafeDownCast(blocks->GetBlock(i)))
    {
      const char* name = blocks->HasMetaData(i) ? blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
      sets.push_back({QString::fromUtf8(name ? name : ""), data});
    }
  return sets;
}

void addSet(vtkMultiBlockDataSet* blocks, const QString& name, vtkDataObject* data)
{
  const unsigned int at = blocks->GetNumberOfBlocks();
  blocks->SetBlock(at, data);
  blocks->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), name.toUtf8().constData());
}

Point cellCentre(vtkDataSet* data, vtkIdType cell)
{
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  Point sum(0, 0, 0);
  for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    sum += Point(data->GetPoint(corners->GetId(k)));
  return (1.0 / static_cast<double>(corners->GetNumberOfIds())) * sum;
}
}  // namespace studio
