// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "Rooms.h"
#include "Student.h"
#include "estimator/solve/Solver.h"
#include "sampling/SampleStream.h"

using namespace kalos;

namespace
{
constexpr int dimensions = SobolColumns::dimensions;

std::vector<std::array<double, dimensions>> walks(Sampling sampling, int count, std::uint64_t seed)
{
  std::vector<std::array<double, dimensions>> points(count);
  for (int i = 0; i < count; ++i)
  {
    SampleStream stream(sampling, seed, 0, Purpose::Trajectory, static_cast<std::uint64_t>(i));
    for (double& u : points[i])
      u = stream.next();
  }
  return points;
}
}  // namespace

// 256 points: one in each of 256 slices of every dimension, and in each cell of all five divisions of the first two
// dimensions into 256 equal rectangles.
TEST(SampleStream, SobolWalksAreStratified)
{
  const auto points = walks(Sampling::Sobol, 256, 7);
  for (int d = 0; d < dimensions; ++d)
  {
    std::vector<int> slices(256);
    for (const auto& p : points)
      ++slices[static_cast<int>(p[d] * 256)];
    EXPECT_EQ(std::vector<int>(256, 1), slices) << "dimension " << d;
  }
  for (int across = 1; across <= 256; across *= 4)
  {
    std::vector<int> cells(256);
    for (const auto& p : points)
      ++cells[static_cast<int>(p[0] * across) * (256 / across) + static_cast<int>(p[1] * (256 / across))];
    EXPECT_EQ(std::vector<int>(256, 1), cells) << across << " columns";
  }
}

// The first eight points, as published with the direction numbers of Joe and Kuo (2008), in eighths.
TEST(SampleStream, SobolPointsAreThePublishedOnes)
{
  constexpr int eighths[8][dimensions] = {{0, 0, 0, 0}, {4, 4, 4, 4}, {2, 6, 6, 6}, {6, 2, 2, 2},
                                          {1, 5, 3, 1}, {5, 1, 7, 5}, {3, 3, 5, 7}, {7, 7, 1, 3}};
  for (std::uint32_t i = 0; i < 8; ++i)
  {
    std::uint32_t bits[dimensions];
    sobolBits(i, dimensions, bits);
    for (int d = 0; d < dimensions; ++d)
      EXPECT_EQ(bits[d], static_cast<std::uint32_t>(eighths[i][d]) << 29) << "point " << i << ", dimension " << d;
  }
}

// All four dimensions at once: 16 cells of 16 points among 256; independent points leave that at once.
TEST(SampleStream, SobolFillsFourDimensionsEvenly)
{
  auto spread = [](Sampling sampling) {
    std::vector<int> cells(16);
    for (const auto& p : walks(sampling, 256, 3))
      ++cells[static_cast<int>(p[0] * 2) * 8 + static_cast<int>(p[1] * 2) * 4 + static_cast<int>(p[2] * 2) * 2 +
              static_cast<int>(p[3] * 2)];
    return *std::max_element(cells.begin(), cells.end()) - *std::min_element(cells.begin(), cells.end());
  };
  EXPECT_EQ(spread(Sampling::Sobol), 0);
  EXPECT_GT(spread(Sampling::Independent), 4);
}

// The mean of one point over seeds is uniform: u of walk 5 in 16 slices over 16 000 seeds, chi-square with 15 degrees
// of freedom below 44.3 (false alarm 1e-4 per dimension).
TEST(SampleStream, EveryPointIsUniformOverSeeds)
{
  for (int d = 0; d < dimensions; ++d)
  {
    std::vector<int> slices(16);
    for (std::uint64_t seed = 0; seed < 16000; ++seed)
    {
      SampleStream stream(Sampling::Sobol, seed, 3, Purpose::Gather, 5);
      double u = 0;
      for (int k = 0; k <= d; ++k)
        u = stream.next();
      ++slices[static_cast<int>(u * 16)];
    }
    double chi2 = 0;
    for (const int n : slices)
      chi2 += (n - 1000.0) * (n - 1000.0) / 1000;
    EXPECT_LT(chi2, 44.3) << "dimension " << d;
  }
}

// Stratification can be disabled without bias: both kinds of sampling give the truth of the furnace, within
// 4.4 standard errors of 24 seeds (false alarm 1e-5 each); and the error is smaller with Sobol's points.
TEST(SampleStream, SobolLeavesTheMeanAndLowersTheVariance)
{
  const Scene scene(rooms::furnace(0.6, 100));
  Receivers receivers;
  receivers.points = {{0, 2.5, 2.5}, {0.01, 2.5, 0}, {2.21, 1.5, 0}};
  receivers.normals = {{1, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  double variance[2] = {};
  for (const Sampling sampling : {Sampling::Independent, Sampling::Sobol})
  {
    std::vector<double> sum(3), errors(3);
    constexpr int seeds = 24;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      Settings settings;
      settings.disabled.insert(Technique::Paths);  // in furnaces, too
      settings.trajectories = 8192;
      settings.seed = static_cast<std::uint64_t>(seed);
      if (sampling == Sampling::Independent)
        settings.disabled.insert(Technique::Stratified);
      const Result result = solve(scene, receivers, settings);
      for (std::size_t r = 0; r < 3; ++r)
      {
        sum[r] += result.illuminance[r] / seeds;
        errors[r] += result.standardError[r] * result.standardError[r] / seeds;
      }
    }
    for (std::size_t r = 0; r < 3; ++r)
    {
      EXPECT_LT(std::abs(sum[r] - 250), 4.4 * std::sqrt(errors[r] / seeds)) << "receiver " << r;
      variance[sampling == Sampling::Sobol] += errors[r];
    }
  }
  EXPECT_LT(variance[1], 0.8 * variance[0]);  // two thirds; its noise is below a twentieth
}

// A black room costs nothing but its direct light: exact, no matter how few trajectories.
TEST(BlackRoom, IsDirectLightAlone)
{
  SceneDescription description = rooms::furnace(0, 100);
  const Scene scene(description);
  Receivers receivers;
  receivers.points = {{0, 0.001, 2.5}};
  receivers.normals = {{1, 0, 0}};
  for (const Method method : {Method::Local, Method::Compensated})
  {
    Settings settings;
    settings.method = method;
    settings.trajectories = 4096;
    const Result result = solve(scene, receivers, settings);
    EXPECT_LT(std::abs(result.illuminance[0] - 100), allowed(result, 2) * result.standardError[0]);
    EXPECT_DOUBLE_EQ(result.illuminance[0], result.direct[0]);
    EXPECT_TRUE(result.trusted[0]);
  }
}

// Slope of the error over the trajectories, 64 seeds each from 512 to 16384: -0.5 for independent sampling within 0.08
// (about 4 standard errors), and steeper by more than that for Sobol's points. In a nearly black room, where the first
// directions carry the noise: of long walks the points make the error smaller, not its slope.
TEST(SampleStream, DISABLED_ErrorSlopes)
{
  const Scene scene(rooms::litRoom(0.02));
  Receivers receivers;
  receivers.points = {{0, 2.5, 2.5}, {2.5, 1.5, 0}, {2.3, 3, 5}};
  receivers.normals = {{1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  double slopes[2];
  for (const Sampling sampling : {Sampling::Independent, Sampling::Sobol})
  {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (long long trajectories = 512; trajectories <= 16384; trajectories *= 2, ++n)
    {
      constexpr int seeds = 64;
      double sums[3] = {}, squares = 0;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      {
        Settings settings;
        settings.method = Method::Local;
        settings.trajectories = trajectories;
        settings.seed = seed;
        if (sampling == Sampling::Independent)
          settings.disabled.insert(Technique::Stratified);
        const Result result = solve(scene, receivers, settings);
        for (int r = 0; r < 3; ++r)
        {
          sums[r] += result.illuminance[r];
          squares += result.illuminance[r] * result.illuminance[r];
        }
      }
      for (const double sum : sums)
        squares -= sum * sum / seeds;
      squares /= 3 * (seeds - 1);
      const double x = std::log(static_cast<double>(trajectories)), y = 0.5 * std::log(squares);
      std::printf("%s, %lld trajectories: %.4f lx of %.1f\n", sampling == Sampling::Sobol ? "Sobol" : "independent",
                  trajectories, std::exp(y), sums[0] / seeds);
      sx += x;
      sy += y;
      sxx += x * x;
      sxy += x * y;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    std::printf("%s: slope %.3f\n", sampling == Sampling::Sobol ? "Sobol" : "independent", slope);
    slopes[sampling == Sampling::Sobol] = slope;
  }
  EXPECT_NEAR(slopes[0], -0.5, 0.08);
  EXPECT_LT(slopes[1], -0.5 - 2 * 0.08);
}
