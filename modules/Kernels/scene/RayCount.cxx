// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RayCount.h"

#include <atomic>
#include <mutex>
#include <set>

namespace kalos
{
namespace
{
struct Counter;

// Never destroyed, so that threads may end during program exit.
struct Registry
{
  std::mutex mutex;
  std::set<const Counter*> counters;
  long long ended = 0;  // rays of threads that have ended
};

Registry& registry()
{
  static auto* only = new Registry;
  return *only;
}

struct Counter
{
  std::atomic<long long> rays{0};  // written by its own thread only: no locked instruction is needed

  Counter()
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    registry().counters.insert(this);
  }

  ~Counter()
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    registry().ended += this->rays.load(std::memory_order_relaxed);
    registry().counters.erase(this);
  }
};
Counter& ownCounter()
{
  static thread_local Counter counter;
  return counter;
}
}  // namespace

void countRays(int rays)
{
  Counter& counter = ownCounter();
  counter.rays.store(counter.rays.load(std::memory_order_relaxed) + rays, std::memory_order_relaxed);
}

long long raysOfThisThread()
{
  return ownCounter().rays.load(std::memory_order_relaxed);
}

long long raysTraced()
{
  const std::lock_guard<std::mutex> lock(registry().mutex);
  long long sum = registry().ended;
  for (const Counter* counter : registry().counters)
    sum += counter->rays.load(std::memory_order_relaxed);
  return sum;
}
}  // namespace kalos
