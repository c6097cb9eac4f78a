// SPDX-License-Identifier: BSD-3-Clause
// Threads, progress, abort and share of the replicates of one solve.
#ifndef kalos_estimator_control_Workers_h
#define kalos_estimator_control_Workers_h

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "estimator/control/Ranks.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"

namespace kalos
{
/// Receivers that one task serves, and the number of such tiles.
constexpr std::size_t tileSize = 32;
inline std::size_t tileCount(std::size_t receivers)
{
  return (receivers + tileSize - 1) / tileSize;
}

class Workers
{
public:
  /// threads 0: all processors. `progress` is called on the constructing thread only, at most 20 times a second.
  Workers(int threads, Progress progress, const Ranks& ranks)
      : Arena(threads > 0 ? threads : tbb::task_arena::automatic), Report(std::move(progress)), Sharing(ranks)
  {
  }

  /// Runs body(i) for i in [0, count) on the threads; returns false when the run was aborted.
  template <class Body>
  bool forEach(std::size_t count, const Body& body)
  {
    if (count == 0)
      return !this->Aborted;
    std::atomic<std::size_t> finished{0};
    {
      const std::lock_guard<std::mutex> open(this->Gate);  // makes earlier writes visible to the tasks
    }
    this->Arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
            {
              {
                const std::lock_guard<std::mutex> open(this->Gate);  // locked while progress is reported
              }
              if (this->Aborted)
                return;
              body(i);
              this->tell(static_cast<double>(finished + 1) / static_cast<double>(count));
              ++finished;  // last, so that a reader of the count sees all finished work
            }
          },
          tbb::simple_partitioner());
    });
    return finished == count && !this->Aborted;
  }

  /// Restricts forEachReplicate() to this replicate.
  void only(int replicate) { this->Only = replicate; }

  /// Replicates [first, last).
  struct Replicates
  {
    int first, last;
  };

  /// Those of `replicates` that this rank owns.
  Replicates mine(int replicates) const
  {
    if (this->Only >= 0)
      return {this->Only, this->Only + 1};
    const int rank = this->Sharing.rank();
    return {this->Sharing.firstReplicate(rank, replicates), this->Sharing.firstReplicate(rank + 1, replicates)};
  }

  /// Runs body(replicate, part) for every part in [0, parts) of these replicates.
  template <class Body>
  bool forEachReplicate(Replicates some, std::size_t parts, const Body& body)
  {
    const int count = some.last - some.first;
    return this->forEach(parts * static_cast<std::size_t>(count),
                         [&](std::size_t i) { body(some.first + static_cast<int>(i % count), i / count); });
  }
  /// The same for those of `replicates` that this rank owns.
  template <class Body>
  bool forEachReplicate(int replicates, std::size_t parts, const Body& body)
  {
    return this->forEachReplicate(this->mine(replicates), parts, body);
  }

  /// The next forEach() covers this part of the whole work.
  void setSpan(double from, double to)
  {
    this->From = from;
    this->To = to;
    this->setStep(0, 1);
  }

  /// The next forEach() covers this one of so many equal steps of the span.
  void setStep(int step, int steps)
  {
    this->Step = step;
    this->Steps = steps;
  }

  bool aborted() const { return this->Aborted; }

  /// Time that progress took, s: pauses do not count as time of the solve.
  double secondsTelling() const { return this->Telling; }

private:
  void tell(double fraction)
  {
    if (!this->Report || std::this_thread::get_id() != this->Caller)
      return;
    const auto now = std::chrono::steady_clock::now();
    if (now - this->LastTold < std::chrono::milliseconds(50))
      return;
    this->LastTold = now;
    const double done = (this->Step + fraction) / this->Steps;
    this->Told = std::max(this->Told, this->From + done * (this->To - this->From));  // never goes back
    const std::lock_guard<std::mutex> closed(this->Gate);
    if (!this->Report(this->Told))
      this->Aborted = true;
    this->Telling += std::chrono::duration<double>(std::chrono::steady_clock::now() - now).count();
  }

  tbb::task_arena Arena;
  Progress Report;
  const Ranks& Sharing;
  std::thread::id Caller = std::this_thread::get_id();
  std::chrono::steady_clock::time_point LastTold{};
  std::atomic<bool> Aborted{false};
  std::mutex Gate;
  int Only = -1, Step = 0, Steps = 1;
  double Telling = 0, From = 0, To = 0, Told = 0;  // work before the first span does not count as progress
};
}  // namespace kalos

#endif
