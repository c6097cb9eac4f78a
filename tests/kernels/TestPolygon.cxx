// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/Polygon.h"
#include "sampling/Random.h"

using namespace kalos;

// Howell C-3 and C-4 (validation.md 5), the reference for rectangles with a corner on the element's axis.
static double parallelCorner(double a, double b, double c)
{
  const double x = a / c, y = b / c;
  return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
         (2 * pi);
}

static double perpendicularCorner(double w, double d, double z)
{
  return (std::atan(w / z) - z / std::hypot(z, d) * std::atan(w / std::hypot(z, d))) / (2 * pi);
}

TEST(Polygon, ParallelRectangle)
{
  for (double c : {1e-4, 0.1, 1.0, 20.0})
  {
    const Vec3 corners[4] = {{0, 0, c}, {3, 0, c}, {3, 2, c}, {0, 2, c}};
    const double exact = parallelCorner(3, 2, c);
    EXPECT_NEAR(polygonFormFactor({0, 0, 0}, {0, 0, 1}, corners, 4), exact, 1e-12 + 1e-9 * exact);
  }
}

TEST(Polygon, PerpendicularRectangleTendsToAHalfAtTheEdge)
{
  for (double z : {1e-6, 1e-3, 0.5, 4.0})
  {
    // The element lies on the floor at distance z from a wall of half width w and height d.
    const Vec3 corners[4] = {{z, -2, 0}, {z, 2, 0}, {z, 2, 3}, {z, -2, 3}};
    const double exact = 2 * perpendicularCorner(2, 3, z);
    EXPECT_NEAR(polygonFormFactor({0, 0, 0}, {0, 0, 1}, corners, 4), exact, 1e-9);
  }
  const Vec3 corners[4] = {{0, -2, 0}, {0, 2, 0}, {0, 2, 3}, {0, -2, 3}};
  EXPECT_NEAR(polygonFormFactor({-1e-12, 0, 0}, {0, 0, 1}, corners, 4), 0.5, 1e-9);
}

TEST(Polygon, HorizonCutsThePart)
{
  // A rectangle symmetric about the horizon counts as its upper half.
  const Vec3 whole[4] = {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}};
  const Vec3 upper[4] = {{1, -1, 0}, {1, 1, 0}, {1, 1, 1}, {1, -1, 1}};
  const Vec3 r{0, 0, 0}, n{0, 0, 1};
  EXPECT_NEAR(polygonFormFactor(r, n, whole, 4), polygonFormFactor(r, n, upper, 4), 1e-14);
  EXPECT_EQ(polygonFormFactor(r, {-1, 0, 0}, whole, 4), 0);
}

// Samples are uniform in solid angle: the mean of cos(theta) Omega / pi is the form factor. 100 000 samples, |z| < 4.4:
// false alarm 1e-5 for each of the four triangles.
TEST(Polygon, SphericalTriangleSamplesTheFormFactor)
{
  const Vec3 triangles[4][3] = {{{0.5, 0, 1}, {2, 0.5, 1.5}, {0, 2, 1}},
                                {{3, 0, 0.01}, {3, 4, 0.02}, {-2, 1, 3}},
                                {{1e-3, 0, 1e-3}, {0, 1e-3, 1e-3}, {-1e-3, -1e-3, 2e-3}},
                                {{50, 0, 40}, {50, 1, 40}, {50, 0, 41}}};
  const Vec3 n{0, 0, 1};
  for (const auto& t : triangles)
  {
    const SphericalTriangle seen({0, 0, 0}, t[0], t[1], t[2]);
    RandomStream random(7, 0, Purpose::DirectLight, 0);
    const int count = 100000;
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i)
    {
      const double u1 = random.next(), u2 = random.next();
      const double score = std::max(0.0, dot(seen.sample(u1, u2), n)) * seen.solidAngle() / pi;
      sum += score;
      squares += score * score;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    const double exact = polygonFormFactor({0, 0, 0}, n, t, 3);
    EXPECT_LT(std::abs(mean - exact), 4.4 * error + 1e-9 * exact);
    EXPECT_LT(error, 0.01 * exact);
  }
}
