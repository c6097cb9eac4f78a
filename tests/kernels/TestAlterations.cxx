// SPDX-License-Identifier: BSD-3-Clause
// The closed forms of the methods that alter the kernel, each against quadrature or a limit.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/kernel/Clamped.h"
#include "estimator/kernel/DiscAverage.h"
#include "estimator/kernel/SphereAverage.h"
#include "geometry/Polygon.h"

using namespace kalos;

// Average of 1/rho^2 over the ball, by quadrature in the shells about the vertex.
static double ballAverage(double d, double epsilon)
{
  const int steps = 200000;
  const double low = std::max(0.0, d - epsilon), high = d + epsilon;
  double sum = d < epsilon ? 4 * pi * (epsilon - d) : 0;  // whole shells
  const double from = d < epsilon ? epsilon - d : low;
  for (int i = 0; i < steps; ++i)
  {
    const double rho = from + (high - from) * (i + 0.5) / steps;
    const double cosine = (rho * rho + d * d - epsilon * epsilon) / (2 * rho * d);
    sum += 2 * pi * (1 - std::clamp(cosine, -1.0, 1.0)) * (high - from) / steps;
  }
  return sum / (4 * pi / 3 * epsilon * epsilon * epsilon);
}

TEST(SphereAverage, ExactWeightIsTheAverageOverTheBall)
{
  for (double ratio : {0.1, 0.5, 0.999, 1.001, 2.0, 10.0})
  {
    const double epsilon = 0.15, d = ratio * epsilon;
    EXPECT_NEAR(sphereWeight(d, epsilon, {true, true}), ballAverage(d, epsilon), 1e-4 * ballAverage(d, epsilon));
  }
  EXPECT_NEAR(sphereWeight(0, 0.1, {true, true}), 3 / 0.01, 1e-9);
  EXPECT_NEAR(sphereWeight(0.1, 0.1, {true, true}), 1.5 / 0.01, 1e-9);
}

// Choice (b): the published weight against the exact one with re-drawing: 0.487 at d = epsilon/2, at worst 0.413 at
// 0.78.
TEST(SphereAverage, PublishedWeightIsLow)
{
  double worst = 1;
  for (int i = 1; i < 4000; ++i)
  {
    const double d = i * 1e-3, epsilon = 1;
    worst = std::min(worst, sphereWeight(d, epsilon, {false, true}) / sphereWeight(d, epsilon, {true, true}));
  }
  EXPECT_NEAR(worst, 0.413, 0.001);
  EXPECT_NEAR(sphereWeight(0.5, 1, {false, true}) / sphereWeight(0.5, 1, {true, true}), 0.487, 0.001);
  EXPECT_DOUBLE_EQ(sphereWeight(2, 1, {false, true}), 3.0 / 13) << "3/(3d^2 + epsilon^2), outside";
  EXPECT_DOUBLE_EQ(sphereWeight(0.5, 1, {false, true}), 3 / 2.25) << "3/(d + epsilon)^2, inside";
  // With rejects as zero: V_ball/V_enclosing = 1/(1 + d/epsilon)^3 inside the ball.
  for (double d : {0.2, 0.7})
    EXPECT_NEAR(sphereWeight(d, 1, {false, true}) / sphereWeight(d, 1, {true, false}), 1 / std::pow(1 + d, 3), 1e-12);
}

// The one-sample estimate has the mean it should: the average over the ball of the kernel with fixed normals, here by
// quadrature over a grid of the ball. 40 000 samples, |z| < 4.4 (false alarm 1e-5 each).
TEST(SphereAverage, OneSampleEstimateIsUnbiased)
{
  const Scene scene(rooms::litRoom(0.5));
  Sensor sensor(placeReceiver(scene, {0, 0, 0}, {0, 0, 1}));
  const Vec3 n = normalized(Vec3{0.3, 0.2, -1});
  const double epsilon = 0.15;
  for (const Vec3& y : {Vec3{0.05, 0.02, 0.06}, Vec3{0.1, -0.05, 0.2}})
    for (bool redraw : {true, false})
    {
      double exact = 0, inBall = 0;
      const int steps = 220;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
          for (int k = 0; k < steps; ++k)
          {
            auto at = [&](int l) { return epsilon * (2 * (l + 0.5) / steps - 1); };
            const Vec3 r{at(i), at(j), at(k)};
            if (length(r) >= epsilon)
              continue;
            const Vec3 d = r - y;
            const double d2 = dot(d, d);
            inBall += 1;
            exact += std::max(0.0, dot(d, n)) * std::max(0.0, -d.z) / (pi * d2 * d2);
          }
      exact /= inBall;
      const SphereAverage average(0.25, epsilon, {true, redraw});
      RandomStream random(9, 0, Purpose::Averaging, 0);
      double sum = 0, squares = 0;
      const int count = 40000;
      for (int i = 0; i < count; ++i)
      {
        const double score = average.kernel(0, sensor, y, n, 0, random);
        sum += score;
        squares += score * score;
      }
      const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
      EXPECT_LT(std::abs(mean - exact), 4.4 * error + 0.005 * exact);
      EXPECT_LT(error, 0.02 * exact);
    }
}

// Closed form against Lambert's formula for a fine polygon, in view, cut by the horizon, and from near.
TEST(DiscAverage, DiscFormFactor)
{
  const Vec3 c{0.2, -0.1, 0.3}, m = normalized(Vec3{0.1, 0.2, 1});
  const double radius = 0.4;
  const Frame frame(m);
  std::vector<Vec3> corners;
  const int sides = 4000;
  for (int i = 0; i < sides; ++i)
  {
    const double phi = 2 * pi * i / sides;
    corners.push_back(c + radius * (std::cos(phi) * frame.s + std::sin(phi) * frame.t));
  }
  for (const Vec3& y : {c + 0.5 * m, c + 2.0 * m + 0.3 * frame.s, c + 0.05 * m + 0.2 * frame.t, c + 0.3 * m + frame.s})
    for (const Vec3& n : {-m, normalized(frame.s - 0.2 * m), normalized(-1.0 * frame.s - 0.7 * m)})
    {
      const double exact = polygonFormFactor(y, n, corners.data(), sides);
      EXPECT_NEAR(discFormFactor(y, n, c, m, radius), exact, 2e-3 * exact + 1e-6);
    }
  EXPECT_EQ(discFormFactor(c - 0.1 * m, m, c, m, radius), 0);
}

TEST(Clamped, LimitIsThatOfFacingElements)
{
  const Clamped clamped(0.5);
  const Scene scene(rooms::litRoom(0.5));
  RandomStream random(1, 0, Purpose::Averaging, 0);
  const Sensor sensor(placeReceiver(scene, {0, 0, 0}, {0, 0, 1}));
  EXPECT_DOUBLE_EQ(clamped.kernel(0, sensor, {}, {}, 7, random), 1 / (pi * 0.25));
  EXPECT_DOUBLE_EQ(clamped.kernel(0, sensor, {}, {}, 0.1, random), 0.1);
}
