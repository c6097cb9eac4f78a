// SPDX-License-Identifier: BSD-3-Clause
// The data sets of a data object, with the names of their blocks.
#ifndef studio_DataSets_h
#define studio_DataSets_h

#include <QString>
#include <QVector>

class vtkDataObject;
class vtkDataSet;

namespace studio
{
struct NamedSet
{
  QString name;  ///< empty for a data object that is a data set itself
  vtkDataSet* data;
};

QVector<NamedSet> dataSets(vtkDataObject* object);
}  // namespace studio

#endif
