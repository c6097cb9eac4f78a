// SPDX-License-Identifier: BSD-3-Clause
// An update for Python that other threads of the interpreter go on during: the wrapping of VTK 9.2 holds the global
// interpreter lock in every call. ctypes does not, and takes the lock for the time of a callback. So nothing in the
// pipeline may have an observer of Python's: events go to the callback instead.
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkKalosFiltersEstimationModule.h"
#include "vtkNew.h"

extern "C"
{
  /// An event: 0 progress, 1 error, 2 warning; the progress in [0, 1]; the text of an error or warning, else null.
  using kalosEvent = void (*)(int kind, double progress, const char* text);

  /// Brings an algorithm up to date and tells its events, and those of its executive.
  VTKKALOSFILTERSESTIMATION_EXPORT void kalosUpdateUnblocked(vtkAlgorithm* algorithm, kalosEvent tell);
}

namespace
{
struct Listener
{
  vtkAlgorithm* Algorithm;
  kalosEvent Tell;
};

void Pass(vtkObject*, unsigned long event, void* clientData, void* callData)
{
  const auto* listener = static_cast<const Listener*>(clientData);
  if (event == vtkCommand::ProgressEvent)
    listener->Tell(0, listener->Algorithm->GetProgress(), nullptr);
  else
    listener->Tell(event == vtkCommand::ErrorEvent ? 1 : 2, 0, static_cast<const char*>(callData));
}
}  // namespace

void kalosUpdateUnblocked(vtkAlgorithm* algorithm, kalosEvent tell)
{
  Listener listener{algorithm, tell};
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Pass);
  command->SetClientData(&listener);
  algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  for (vtkObject* object : {static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive())})
  {
    object->AddObserver(vtkCommand::ErrorEvent, command);
    object->AddObserver(vtkCommand::WarningEvent, command);
  }
  algorithm->Update();
  algorithm->RemoveObserver(command);
  algorithm->GetExecutive()->RemoveObserver(command);
}
