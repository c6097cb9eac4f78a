// SPDX-License-Identifier: BSD-3-Clause
#include "base/ErrorCollector.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"

namespace studio
{
vtkSmartPointer<ErrorCollector> ErrorCollector::watch(vtkAlgorithm* algorithm)
{
  auto collector = vtk::TakeSmartPointer(new ErrorCollector);
  algorithm->AddObserver(vtkCommand::ErrorEvent, collector);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  return collector;
}

void ErrorCollector::Execute(vtkObject*, unsigned long, void* data)
{
  // "ERROR: In FILE, line N\nCLASS (ADDRESS): the message\n\n"
  const QString text = QString::fromUtf8(static_cast<const char*>(data));
  const QString line = text.section(QStringLiteral("): "), 1).trimmed();
  if (this->Message.isEmpty())
    this->Message = line.isEmpty() ? text.trimmed() : line;
}
}  // namespace studio
