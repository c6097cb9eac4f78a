// SPDX-License-Identifier: BSD-3-Clause
// Collects the error events of a VTK algorithm, so that they can be thrown as a Problem.
#ifndef studio_ErrorCollector_h
#define studio_ErrorCollector_h

#include <QString>

#include "vtkCommand.h"
#include "vtkSmartPointer.h"

class vtkAlgorithm;

namespace studio
{
class ErrorCollector : public vtkCommand
{
public:
  static vtkSmartPointer<ErrorCollector> watch(vtkAlgorithm* algorithm);

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  /// The first error, without VTK's file, line and address; empty if there was none.
  const QString& message() const { return this->Message; }

private:
  QString Message;
};
}  // namespace studio

#endif
