// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "sampling/Random.h"
#include "sampling/Warp.h"

using namespace kalos;

TEST(Random, TheSameKeyGivesTheSameNumbersAndAnyOtherKeyOthers)
{
  RandomStream first(3, 1, Purpose::Trajectory, 5), again(3, 1, Purpose::Trajectory, 5);
  EXPECT_EQ(first.next(), again.next());
  const double reference = RandomStream(3, 1, Purpose::Trajectory, 5).next();
  EXPECT_NE(reference, RandomStream(4, 1, Purpose::Trajectory, 5).next());
  EXPECT_NE(reference, RandomStream(3, 2, Purpose::Trajectory, 5).next());
  EXPECT_NE(reference, RandomStream(3, 1, Purpose::Gather, 5).next());
  EXPECT_NE(reference, RandomStream(3, 1, Purpose::Trajectory, 6).next());
}

// Chi-square of 2-D cells over neighbouring indices, dimensions and replicates: 256 cells, 255 degrees of freedom,
// bound 360 (false alarm about 1e-5 each).
TEST(Random, NeighbouringStreamsAreIndependent)
{
  for (int pairing = 0; pairing < 3; ++pairing)
  {
    std::vector<int> cells(256);
    const int count = 256 * 400;
    for (int i = 0; i < count; ++i)
    {
      RandomStream a(1, 0, Purpose::Trajectory, i);
      const double x = a.next();
      const double y = pairing == 0   ? a.next()
                       : pairing == 1 ? RandomStream(1, 0, Purpose::Trajectory, i + 1).next()
                                      : RandomStream(1, 1, Purpose::Trajectory, i).next();
      ++cells[static_cast<int>(x * 16) * 16 + static_cast<int>(y * 16)];
    }
    double chi2 = 0;
    for (int n : cells)
      chi2 += (n - 400.0) * (n - 400.0) / 400.0;
    EXPECT_LT(chi2, 360) << "pairing " << pairing;
    EXPECT_GT(chi2, 165) << "pairing " << pairing;
  }
}

// The density of a map without random numbers: equal cells of the square map to equal shares, here the share of
// directions steeper than 60 degrees: sin^2 = 1/4 of cosine-weighted ones, (1 - cos 60)/2 of uniform ones.
TEST(Warp, SharesOfDirections)
{
  int cosine = 0, uniform = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double u1 = (i + 0.5) / n, u2 = (j + 0.5) / n;
      cosine += cosineHemisphere(u1, u2).z > std::cos(pi / 6);
      uniform += uniformSphere(u1, u2).z > 0.5;
    }
  // The half-size triangle at the first corner has a quarter of the area, that at the third too.
  int first = 0, third = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      double b1, b2;
      uniformTriangle((i + 0.5) / n, (j + 0.5) / n, b1, b2);
      first += b1 + b2 < 0.5;
      third += b2 > 0.5;
    }
  EXPECT_NEAR(first / double(n * n), 0.25, 1e-9);
  EXPECT_NEAR(third / double(n * n), 0.25, 2e-3);  // cells of the square straddle its border
  EXPECT_NEAR(cosine / double(n * n), 0.25, 1e-9);
  EXPECT_NEAR(uniform / double(n * n), 0.25, 1e-9);
}
