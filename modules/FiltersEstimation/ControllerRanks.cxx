// SPDX-License-Identifier: BSD-3-Clause
#include "ControllerRanks.h"

#include "vtkMultiProcessController.h"

int ControllerRanks::rank() const
{
  return this->size() > 1 ? this->Controller->GetLocalProcessId() : 0;
}

int ControllerRanks::size() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

std::vector<double> ControllerRanks::gather(const std::vector<double>& own) const
{
  if (this->size() == 1)
    return own;
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(this->size()), offsets(this->size());
  bool done = this->Controller->AllGather(&length, lengths.data(), 1) != 0;
  vtkIdType total = 0;
  for (int r = 0; r < this->size(); ++r)
  {
    offsets[r] = total;
    total += lengths[r];
  }
  std::vector<double> all(static_cast<std::size_t>(total));
  done = done && this->Controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data()) != 0;
  if (!done)
    throw std::runtime_error("ranks: VTK's communicator could not gather their sums");
  return all;
}
