// SPDX-License-Identifier: BSD-3-Clause
#include "base/DataSets.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

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
}  // namespace studio
