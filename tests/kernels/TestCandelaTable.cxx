// SPDX-License-Identifier: BSD-3-Clause
// Candela tables: look-up, flux and sampling against each other and against closed forms.
#include <gtest/gtest.h>

#include "luminaire/Luminaire.h"
#include "sampling/Random.h"

using namespace kalos;

namespace
{
constexpr double degree = pi / 180;

template <class Intensity>
CandelaTable tabulate(std::vector<double> planes, double angleStep, double lastAngle, Intensity intensity,
                      CandelaTable::Pole pole = CandelaTable::Pole::Axis)
{
  std::vector<double> angles, candela;
  for (int a = 0; a * angleStep <= lastAngle + 1e-9; ++a)
    angles.push_back(a * angleStep);
  for (double plane : planes)
    for (double angle : angles)
      candela.push_back(intensity(plane, angle));
  return CandelaTable(std::move(planes), std::move(angles), std::move(candela), pole);
}

CandelaTable uneven(CandelaTable::Pole pole)
{
  return tabulate(
      {-90, -40, -10, 0, 33, 90}, 7.5, 180,
      [](double p, double a) { return 100 + p + 3 * a + (a > 60 ? 0.02 * p * a : 0); }, pole);
}
}  // namespace

// A table that is constant makes 4 pi I; a cosine has lost little by being bilinear: its chords lie 1 - (h/2)^2/2 low.
TEST(CandelaTable, fluxOfKnownDistributions)
{
  EXPECT_NEAR(tabulate({0, 360}, 30, 180, [](double, double) { return 5; }).flux(), 20 * pi, 1e-12 * 20 * pi);
  const double cosine = tabulate({0, 360}, 0.5, 90, [](double, double a) { return std::cos(a * degree); }).flux();
  EXPECT_NEAR(cosine, pi, 1e-5 * pi);
  EXPECT_LT(cosine, pi);
  // I = 1 + a/180: the integral of a sin(a) over [0, pi] is pi, so 2 pi (2 + pi/pi).
  const auto linear = tabulate({0, 90, 360}, 180, 180, [](double, double a) { return 1 + a / 180; });
  EXPECT_NEAR(linear.flux(), 6 * pi, 1e-13 * 6 * pi);
}

// The closed form against a midpoint rule over each cell.
TEST(CandelaTable, fluxIsTheIntegralOfTheLookUp)
{
  for (auto pole : {CandelaTable::Pole::Axis, CandelaTable::Pole::Side})
  {
    const CandelaTable table = uneven(pole);
    constexpr int n = 1800;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k)
      {
        const double plane = -90 + 180 * (i + 0.5) / n, angle = 180 * (k + 0.5) / n;
        sum += table.intensity(plane, angle) * std::sin(angle * degree) * (180.0 / n * degree) * (180.0 / n * degree);
      }
    EXPECT_NEAR(table.flux(), sum, 1e-5 * sum);
  }
}

TEST(CandelaTable, directionsMeetTheirAngles)
{
  const CandelaTable c = uneven(CandelaTable::Pole::Axis), b = uneven(CandelaTable::Pole::Side);
  RandomStream random(1, 0, Purpose::Trajectory, 0);
  for (int i = 0; i < 1000; ++i)
  {
    const double plane = 180 * random.next() - 90, angle = 180 * random.next();
    const double s = std::sin(angle * degree), cosine = std::cos(angle * degree);
    const double along = s * std::cos(plane * degree), across = s * std::sin(plane * degree);
    EXPECT_NEAR(c.intensity({along, across, cosine}), c.intensity(plane, angle), 1e-9 * c.largest());
    EXPECT_NEAR(b.intensity({across, cosine, along}), b.intensity(plane, angle), 1e-9 * b.largest());
  }
  // Dark where nothing was measured.
  EXPECT_EQ(c.intensity({-1, 0, 0}), 0);
  EXPECT_EQ(b.intensity({0, 0, -1}), 0);
  EXPECT_GT(b.intensity({0, 0, 1}), 0);
}

// Lit in one octant only: every sample lies there, also when the luminaire is turned.
TEST(CandelaTable, samplesLieWhereThereIsLight)
{
  for (auto pole : {CandelaTable::Pole::Axis, CandelaTable::Pole::Side})
  {
    Luminaire lamp;
    lamp.distribution = Distribution::Measured;
    lamp.flux = 100;
    lamp.axis = normalized(Vec3{1, 2, -2});
    lamp.up = normalized(cross(lamp.axis, Vec3{0, 0, 1}));
    lamp.table = std::make_shared<CandelaTable>(tabulate(
        {0, 40, 90}, 10, 90, [](double, double) { return 1; }, pole));
    RandomStream random(1, 0, Purpose::Trajectory, 0);
    for (int i = 0; i < 500; ++i)
    {
      const double u1 = random.next(), u2 = random.next();
      EXPECT_GT(lamp.table->intensity(lamp.table->sample(u1, u2)), 0);
      EXPECT_GT(intensity(lamp, sampleDirection(lamp, u1, u2)), 0);
    }
  }
}

TEST(CandelaTable, closedCirclesHaveNoSeam)
{
  const auto table = tabulate({0, 90, 180, 270, 360}, 10, 180, [](double p, double) { return p == 270 ? 7.0 : 1.0; });
  EXPECT_DOUBLE_EQ(table.intensity(-90, 30), 7);
  EXPECT_NEAR(table.intensity(359.9, 30), table.intensity(-0.1, 30), 1e-12);
  EXPECT_DOUBLE_EQ(table.intensity(720 + 270, 30), 7);
}

TEST(CandelaTable, upwardFlux)
{
  const auto both = tabulate({0, 360}, 15, 180, [](double, double) { return 1; });
  EXPECT_NEAR(both.upwardFlux(), 2 * pi, 1e-12);
  EXPECT_FALSE(both.isOneSided());
  EXPECT_TRUE(tabulate({0, 360}, 15, 90, [](double, double) { return 1; }).isOneSided());
  EXPECT_TRUE(uneven(CandelaTable::Pole::Side).isOneSided());
}

// The share of samples in a bin against the exact share of the flux: 24 bins and two tables at 4.5 standard errors,
// false alarm below 1e-3.
TEST(CandelaTable, samplesFollowTheIntensity)
{
  for (auto pole : {CandelaTable::Pole::Axis, CandelaTable::Pole::Side})
  {
    const CandelaTable table = uneven(pole);
    constexpr int samples = 200000;
    double sums[4][6] = {};
    RandomStream random(7, 0, Purpose::Trajectory, 0);
    for (int i = 0; i < samples; ++i)
    {
      const double u1 = random.next(), u2 = random.next();
      const Vec3 d = table.sample(u1, u2);
      ASSERT_NEAR(length(d), 1, 1e-12);
      ASSERT_GT(table.intensity(d), 0);
      const bool axis = pole == CandelaTable::Pole::Axis;
      const double plane = axis ? std::atan2(d.y, d.x) : std::atan2(d.x, d.z);
      const double angle = std::acos(std::clamp(axis ? d.z : d.y, -1.0, 1.0));
      ++sums[std::min(3, static_cast<int>((plane / degree + 90) / 45))]
            [std::min(5, static_cast<int>(angle / degree / 30))];
    }
    for (int p = 0; p < 4; ++p)
      for (int a = 0; a < 6; ++a)
      {
        // Bilinear cells cut at the bins' borders: a table of its own, exact.
        std::vector<double> planes, angles, candela;
        for (double x = -90 + 45 * p; x <= -45 + 45 * p; x += 1)
          planes.push_back(x);
        for (double x = 30 * a; x <= 30 + 30 * a; x += 0.5)
          angles.push_back(x);
        for (double x : planes)
          for (double y : angles)
            candela.push_back(table.intensity(x, y));
        const double share = CandelaTable(planes, angles, candela, pole).flux() / table.flux();
        const double error = std::sqrt(share * (1 - share) / samples);
        EXPECT_NEAR(sums[p][a] / samples, share, 4.5 * error) << p << " " << a;
        EXPECT_LT(error, 0.05 * share);
      }
  }
}

// u in order of the table: the first and last numbers give the ends, and zero cells are never drawn.
TEST(CandelaTable, samplingAvoidsDarkCells)
{
  const auto spot =
      tabulate({0, 90, 180, 360}, 10, 180, [](double p, double a) { return p == 90 && a == 40 ? 1.0 : 0.0; });
  for (double u1 : {0.0, 0.25, 0.5, 0x1.fffffffffffffp-1})
    for (double u2 : {0.0, 0.5, 0x1.fffffffffffffp-1})
    {
      const Vec3 d = spot.sample(u1, u2);
      const double angle = std::acos(d.z) / degree, plane = std::atan2(d.y, d.x) / degree;
      EXPECT_GE(angle, 30 - 1e-6);
      EXPECT_LE(angle, 50 + 1e-6);
      EXPECT_GE(plane, -1e-6);
      EXPECT_LE(std::abs(plane), 180 + 1e-6);
    }
}
