// SPDX-License-Identifier: BSD-3-Clause
/** Collects the error events of a VTK algorithm and its executive and turns them into one line. */
#ifndef KalosErrorCatcher_h
#define KalosErrorCatcher_h

#include <string>

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

namespace kalos::scene
{
class ErrorCatcher
{
public:
  /** Warnings count as errors; with `tolerant` they are only kept off the screen. */
  explicit ErrorCatcher(vtkAlgorithm* algorithm, bool tolerant = false)
  {
    this->Observer->tolerant = tolerant;
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    algorithm->AddObserver(vtkCommand::WarningEvent, this->Observer);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }

  /** For objects inside the algorithm that report errors of their own. */
  vtkCommand* command() const { return this->Observer.Get(); }

  bool empty() const { return this->Observer->text.empty(); }

  /** The first message without VTK's "ERROR: In FILE, line N" and the object's address. */
  std::string firstLine() const
  {
    std::string text = this->Observer->text;
    const std::size_t start = text.find("): ");
    text = start == std::string::npos ? text : text.substr(start + 3);
    return text.substr(0, text.find_first_of("\r\n"));
  }

private:
  struct Collector : public vtkCommand
  {
    static Collector* New() { return new Collector; }
    void Execute(vtkObject*, unsigned long event, void* data) override
    {
      if (this->text.empty() && !(this->tolerant && event == vtkCommand::WarningEvent))
      {
        this->text = data ? static_cast<const char*>(data) : "unknown error";
      }
    }
    std::string text;
    bool tolerant = false;
  };

  vtkNew<Collector> Observer;
};
}  // namespace kalos::scene

#endif
