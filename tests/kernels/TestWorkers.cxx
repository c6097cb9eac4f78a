// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "estimator/Workers.h"

using namespace kalos;

TEST(Workers, RestWhileProgressIsTold)
{
  constexpr int threads = 3, tasks = 3000;
  std::atomic<int> begun{0}, told{0};
  const Ranks alone;
  auto rest = [&](double) {
    if (++told > 3)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // what had passed the gate begins
    const int before = begun;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(begun, before);
    return true;
  };
  Workers workers(threads, rest, alone);
  EXPECT_TRUE(workers.forEach(tasks, [&](std::size_t) {
    ++begun;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }));
  EXPECT_EQ(begun, tasks);
  EXPECT_GE(told, 3);
}
