// SPDX-License-Identifier: BSD-3-Clause
#include "ControllerRanks.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "vtkMultiProcessController.h"

#if VTK_MODULE_ENABLE_VTK_ParallelMPI
#include "vtkMPIController.h"

namespace
{
constexpr int arrival = 51307;  // tag of the messages by which ranks meet
constexpr int here = 1;         // what they say

double PatienceInSeconds()
{
  const char* given = std::getenv("KALOS_RANK_PATIENCE");
  const double seconds = given ? std::atof(given) : 0;
  return seconds > 0 ? seconds : 60;
}
}  // namespace
#endif

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
  if (!this->Met)
    this->meet();
  this->Met = true;
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

void ControllerRanks::meet() const
{
#if VTK_MODULE_ENABLE_VTK_ParallelMPI
  auto* mpi = vtkMPIController::SafeDownCast(this->Controller);
  if (!mpi)
    return;
  using Clock = std::chrono::steady_clock;
  const double patience = PatienceInSeconds();
  const auto last = Clock::now() + std::chrono::duration<double>(patience);
  std::vector<int> theirs(this->size());
  std::vector<vtkMPICommunicator::Request> coming(this->size()), sent(this->size());
  for (int r = 0; r < this->size(); ++r)
    if (r != this->rank())
    {
      mpi->NoBlockReceive(&theirs[r], 1, r, arrival, coming[r]);
      mpi->NoBlockSend(&here, 1, r, arrival, sent[r]);
    }
  int absent = -1;
  for (int r = 0; r < this->size(); ++r)
  {
    bool came = r == this->rank() || coming[r].Test();
    while (!came && Clock::now() < last)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      came = coming[r].Test();
    }
    if (!came)
    {
      coming[r].Cancel();
      absent = r;
    }
  }
  if (absent >= 0)
    throw std::runtime_error("rank " + std::to_string(absent) + " of " + std::to_string(this->size()) +
                             ": did not come to the solve within " + std::to_string(std::lround(patience)) +
                             " s (KALOS_RANK_PATIENCE); expected that every rank updates the same filters");
#endif
}
