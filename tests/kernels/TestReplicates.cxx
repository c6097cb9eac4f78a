// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "statistics/Replicates.h"

using namespace kalos;

TEST(Replicates, MeanAndError)
{
  const double values[4] = {1, 2, 3, 6};
  const MeanAndError m = summarise(values, 4);
  EXPECT_DOUBLE_EQ(m.mean, 3);
  EXPECT_DOUBLE_EQ(m.standardError, std::sqrt(14.0 / 3 / 4));
}

TEST(Replicates, StudentQuantilesOfTheTables)
{
  EXPECT_NEAR(studentQuantile(0.95, 1), 12.706, 5e-4);
  EXPECT_NEAR(studentQuantile(0.95, 2), 4.303, 5e-4);
  EXPECT_NEAR(studentQuantile(0.95, 5), 2.571, 5e-4);
  EXPECT_NEAR(studentQuantile(0.95, 24), 2.064, 5e-4);
  EXPECT_NEAR(studentQuantile(0.95, 31), 2.040, 5e-4);
  EXPECT_NEAR(studentQuantile(0.99, 31), 2.744, 5e-4);
}

TEST(Replicates, CountDividesTheTrajectories)
{
  EXPECT_EQ(replicateCount(1), 2);
  EXPECT_EQ(replicateCount(20), 20);
  EXPECT_EQ(replicateCount(100), 25);
  EXPECT_EQ(replicateCount(10000), 25);
  EXPECT_EQ(replicateCount(65536), 32);
  EXPECT_EQ(replicateCount(10007), 32);
  EXPECT_EQ(fewReplicates(1), 2);
  EXPECT_EQ(fewReplicates(7), 7);
  EXPECT_EQ(fewReplicates(100), 5);
  EXPECT_EQ(fewReplicates(65536), 8);
  EXPECT_EQ(fewReplicates(10007), 8);
}
