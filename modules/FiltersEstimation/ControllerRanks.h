// SPDX-License-Identifier: BSD-3-Clause
// VTK's processes as the kernels see them.
#ifndef ControllerRanks_h
#define ControllerRanks_h

#include "estimator/Ranks.h"

class vtkMultiProcessController;

class ControllerRanks : public kalos::Ranks
{
public:
  /// Null: this process alone.
  explicit ControllerRanks(vtkMultiProcessController* controller) : Controller(controller) {}

  int rank() const override;
  int size() const override;
  /// Throws std::runtime_error when VTK's communicator fails.
  std::vector<double> gather(const std::vector<double>& own) const override;

private:
  vtkMultiProcessController* Controller;
};

#endif
