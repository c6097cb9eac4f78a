// SPDX-License-Identifier: BSD-3-Clause
// VTK's processes as the kernels see them.
//
// A rank whose script or reader fails never comes to the solve, and VTK tells no filter so. The others wait for it for
// 60 s, or as many as the environment variable KALOS_RANK_PATIENCE says, and then fail with a message instead of
// waiting for ever. Within a solve Ranks::together() sees to that.
#ifndef ControllerRanks_h
#define ControllerRanks_h

#include "estimator/control/Ranks.h"

class vtkMultiProcessController;

class ControllerRanks : public kalos::Ranks
{
public:
  /// Null: this process alone.
  explicit ControllerRanks(vtkMultiProcessController* controller) : Controller(controller) {}

  int rank() const override;
  int size() const override;
  /// Throws std::runtime_error when VTK's communicator fails, or when a rank does not come.
  std::vector<double> gather(const std::vector<double>& own) const override;

private:
  void meet() const;

  vtkMultiProcessController* Controller;
  mutable bool Met = false;
};

#endif
