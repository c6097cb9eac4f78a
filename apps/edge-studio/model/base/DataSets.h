// SPDX-License-Identifier: BSD-3-Clause
// The data sets of a data object with the names of their blocks, and the centres of their cells.
#ifndef studio_DataSets_h
#define studio_DataSets_h

#include <QString>
#include <QVector>

#include "base/Point.h"
#include "vtkType.h"

class vtkDataObject;
class vtkDataSet;
class vtkMultiBlockDataSet;

namespace studio
{
struct NamedSet
{
  QString name;  ///< empty for a data object that is a data set itself
  vtkDataSet* data;
};

QVector<NamedSet> dataSets(vtkDataObject* object);

/// Appends a block with its name.
void addSet(vtkMultiBlockDataSet* blocks, const QString& name, vtkDataObject* data);

/// The mean of a cell's corners, m.
Point cellCentre(vtkDataSet* data, vtkIdType cell);
}  // namespace studio

#endif
