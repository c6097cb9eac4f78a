// SPDX-License-Identifier: BSD-3-Clause
// Variances of neighbouring receivers, averaged.
#include <gtest/gtest.h>

#include "estimator/tally/PooledErrors.h"

using namespace kalos;

namespace
{
PooledErrors inARow(int count)
{
  Receivers receivers;
  for (int i = 0; i < count; ++i)
    receivers.points.push_back({0.125 * i, 0, 0});
  receivers.normals.assign(receivers.points.size(), {0, 0, 1});
  return PooledErrors(receivers);
}
}  // namespace

// Four neighbours on either side, fewer at the ends; what does not fluctuate is none.
TEST(PooledErrors, AreMeansOverNeighbours)
{
  std::vector<double> variances(20, 1.0);
  variances[10] = 3;
  variances[2] = 0;
  const std::vector<double> pooled = inARow(20).pool(variances);
  EXPECT_EQ(pooled[2], 0);
  EXPECT_EQ(pooled[5], 1);
  for (std::size_t i = 6; i <= 14; ++i)
    EXPECT_NEAR(pooled[i], 11.0 / 9, 1e-12) << i;
  EXPECT_EQ(pooled[15], 1);
  variances[19] = 2;
  EXPECT_NEAR(inARow(20).pool(variances)[19], 1.2, 1e-12);
}

// Just above five times the neighbours', a receiver keeps its own and leaves them theirs; just below, it shares.
TEST(PooledErrors, OutliersKeepTheirOwn)
{
  std::vector<double> variances(20, 1.0);
  variances[10] = 5.01;
  EXPECT_EQ(inARow(20).pool(variances)[10], 5.01);
  EXPECT_EQ(inARow(20).pool(variances)[11], 1);
  variances[10] = 4.99;
  EXPECT_NEAR(inARow(20).pool(variances)[10], 12.99 / 9, 1e-12);
}

// Two pairs, 0.1 m in themselves and 0.55 m from each other: pairs share.
TEST(PooledErrors, FarPointsAreNoNeighbours)
{
  Receivers receivers;
  receivers.points = {{0, 0, 0}, {0.1, 0, 0}, {0.65, 0, 0}, {0.75, 0, 0}};
  receivers.normals.assign(4, {0, 0, 1});
  const std::vector<double> pooled = PooledErrors(receivers).pool({1, 2, 3, 4});
  const double expected[] = {1.5, 1.5, 3.5, 3.5};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(pooled[i], expected[i], 1e-12) << i;
}

TEST(PooledErrors, OneAloneHasItsOwn)
{
  EXPECT_EQ(inARow(1).pool({2.5}), std::vector<double>{2.5});
  EXPECT_TRUE(inARow(0).pool({}).empty());
}
