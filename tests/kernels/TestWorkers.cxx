// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "estimator/control/Workers.h"

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

// A step reports progress for its part of the span only; the next span resets the steps.
TEST(Workers, StepsShareTheSpan)
{
  const Ranks alone;
  std::vector<double> told;
  Workers workers(
      1,
      [&](double fraction) {
        told.push_back(fraction);
        return true;
      },
      alone);
  auto work = [&] {
    told.clear();
    EXPECT_TRUE(workers.forEach(3, [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(60)); }));
    ASSERT_EQ(told.size(), 3u);
  };
  workers.setSpan(0.2, 0.6);
  workers.setStep(0, 4);
  work();
  EXPECT_NEAR(told.front(), 0.2 + 0.1 / 3, 1e-12);
  EXPECT_NEAR(told.back(), 0.3, 1e-12);
  workers.setStep(3, 4);
  work();
  EXPECT_NEAR(told.back(), 0.6, 1e-12);
  workers.setSpan(0.6, 1);
  work();
  EXPECT_NEAR(told.back(), 1, 1e-12);
}
