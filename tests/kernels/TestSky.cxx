// SPDX-License-Identifier: BSD-3-Clause
// Skies and their integrals.
#include <gtest/gtest.h>

#include "Skies.h"

using namespace skies;

namespace
{
// E on a plane of normal n by midpoints over the sky in z and azimuth.
double byMidpoints(const Sky& sky, const Vec3& n, int rows)
{
  double sum = 0;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < 4 * rows; ++j)
    {
      const double z = (i + 0.5) / rows, s = std::sqrt(1 - z * z), phi = 2 * pi * (j + 0.5) / (4 * rows);
      const Vec3 d{s * std::cos(phi), s * std::sin(phi), z};
      sum += sky.luminance(d) * std::max(0.0, dot(d, n)) * 2 * pi / (4 * rows * rows);
    }
  return sum;
}
}  // namespace

TEST(Sky, AllTypesHaveTheHorizontalIlluminanceThatIsGiven)
{
  for (int type = 1; type <= 16; ++type)
  {
    const auto sky = cie(type, 10000, 0, {0.3, -0.6, 0});
    EXPECT_NEAR(byMidpoints(*sky, {0, 0, 1}, 400), 10000, 0.2) << type;
    EXPECT_NEAR(sky->illuminance({0, 0, 1}), 10000, 1e-8) << type;
  }
}

TEST(Sky, TiltedPlanesAreIntegratedExactly)
{
  for (int type = 1; type <= 15; ++type)
  {
    const auto sky = cie(type, 10000, 0, {0.3, -0.6, 0});
    for (const Vec3& tilted : {Vec3{0, 1, 0}, Vec3{1, -1, 0.5}, Vec3{-1, 0.2, -0.4}})
    {
      const Vec3 n = normalized(tilted);
      const double truth = byMidpoints(*sky, n, 400);
      EXPECT_NEAR(sky->illuminance(n) / truth, 1, 2e-4) << type;
    }
  }
  // (1 + 2 sin gamma) / 3 on an upright plane: (pi/2 + 4/3) / (7 pi / 3) of the horizontal.
  EXPECT_NEAR(cie(16)->illuminance({1, 0, 0}), 10000 * (pi / 2 + 4.0 / 3) / (7 * pi / 3), 1e-2);
  const auto ground = cie(5, 10000, 0.3);
  EXPECT_NEAR(ground->illuminance({1, 0, 0}), 6500, 1e-9);
  EXPECT_NEAR(ground->illuminance({0, 0, -1}), 3000, 1e-9);
  EXPECT_NEAR(ground->groundLuminance(), 3000 / pi, 1e-9);
}

TEST(Sky, ItsZenithMayBeGiven)
{
  SkyDescription d;
  d.pattern = makeSky(cieSky(5), {0, 0, 1});
  d.zenithLuminance = 2000;
  EXPECT_NEAR(Sky(d).horizontalIlluminance(), 2000 * pi, 1e-6);
  d.pattern = makeTraditionalOvercast();
  EXPECT_NEAR(Sky(d).horizontalIlluminance(), 2000 * 7 * pi / 9, 1e-6);
}

TEST(Sky, TheSunIsADisc)
{
  const auto sky = cie(12, 10000, 0.2, {0.3, 0.4, 0}, 80000);
  Vec3 sum;
  for (int i = 0; i < 4096; ++i)
  {
    const Vec3 d = sky->sampleSun((i % 64 + 0.5) / 64, (i / 64 + 0.5) / 64);
    EXPECT_TRUE(sky->inDisc(d));
    sum += (sky->sunLuminance() * Sky::sunSolidAngle / 4096) * d;
  }
  EXPECT_NEAR(dot(sum, sky->sun()), 80000, 0.1);
  const Vec3 across = normalized(cross(sky->sun(), {0, 0, 1}));
  EXPECT_TRUE(sky->inDisc(normalized(sky->sun() + std::tan(0.264 * pi / 180) * across)));
  EXPECT_FALSE(sky->inDisc(normalized(sky->sun() + std::tan(0.266 * pi / 180) * across)));
}

// A density integrates to 1, and what is drawn follows it.
TEST(Sky, DirectionsAreDrawnByTheirDensity)
{
  const auto sky = cie(13, 10000, 0.3, {0.3, 0.4, 0});
  const DirectionTable& table = sky->directions();
  EXPECT_NEAR(table.integral(), sky->directions().integral(), 1e-9);
  double sum = 0;
  constexpr int n = 256;
  for (int i = 0; i < n * n; ++i)
  {
    const Vec3 d = table.sample((i / n + 0.5) / n, (i % n + 0.5) / n);
    sum += sky->luminance(d) * std::max(0.0, d.z) / table.density(d) / (n * n);
  }
  EXPECT_NEAR(sum, 10000, 10);
}

TEST(Sky, PerezGoesFromOvercastToClear)
{
  // Overcast: nearly no direct irradiance. Clear: bright about the sun.
  const PerezSky dull = perezSky({0, 150, pi / 3}), clear = perezSky({850, 90, pi / 3});
  EXPECT_NEAR(dull.diffuseIlluminance / 150, 115, 15);  // lm/W
  EXPECT_EQ(dull.directNormalIlluminance, 0);
  EXPECT_NEAR(clear.diffuseIlluminance / 90, 135, 20);
  EXPECT_NEAR(clear.directNormalIlluminance / 850, 100, 12);
  const Vec3 sun{std::sin(pi / 3), 0, std::cos(pi / 3)}, opposite{-sun.x, 0, sun.z};
  const auto bright = makeSky(clear.coefficients, sun);
  EXPECT_GT(bright->relative(sun), 5 * bright->relative(opposite));
  const auto grey = makeSky(dull.coefficients, sun);
  EXPECT_GT(grey->relative({0, 0, 1}), 1.15 * grey->relative(normalized({1, 0, 0.05})));
}

TEST(Sky, RefusesWhatMakesNoSense)
{
  SkyDescription d;
  EXPECT_THROW(Sky{d}, std::invalid_argument);
  d.pattern = makeSky(cieSky(1), {0, 0, 1});
  d.groundReflectance = 1.5;
  EXPECT_THROW(Sky{d}, std::invalid_argument);
  d.groundReflectance = 0;
  d.sun = {0, 0, 2};
  EXPECT_THROW(Sky{d}, std::invalid_argument);
  EXPECT_THROW(cieSky(16), std::invalid_argument);
}
