// SPDX-License-Identifier: BSD-3-Clause
// Unified glare rating against published position indices and closed forms.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/quantities/GlareRating.h"

using kalos::GlareSum;
using kalos::glareSum;
using kalos::Observer;
using kalos::pi;
using kalos::positionIndex;
using kalos::Vec3;

namespace
{
const Observer eye{{0, 0, 1.2}, {0, 1, 0}, {0, 0, 1}};

/// Direction of a source at a height and a distance aside, in units of the distance ahead, as tables of p give them.
Vec3 direction(double height, double aside)
{
  return kalos::normalized({aside, 1, height});
}

kalos::Luminaire panel(const Vec3& centre, double side, double flux)
{
  kalos::Luminaire l;
  l.position = centre;
  l.flux = flux;
  l.sideU = {side, 0, 0};
  l.sideV = {0, side, 0};
  return l;
}
}  // namespace

TEST(GlareRating, PositionIndexIsThatOfTheTables)
{
  // Entries of the table in CIE 117 by H/R and T/R; Levin's equation is within a few per cent of them.
  const double table[][3] = {{0, 0, 1.00},   {0.1, 0, 1.26},   {0.5, 0, 2.86}, {1, 0, 7.00}, {1.5, 0, 13.15},
                             {0, 0.5, 1.43}, {0.5, 0.5, 2.91}, {0, 1, 2.11},   {1, 1, 7.00}, {0, 2, 3.50}};
  for (const auto& [height, aside, index] : table)
    EXPECT_NEAR(positionIndex(eye, direction(height, aside)), index, 0.04 * index) << height << " " << aside;
  EXPECT_TRUE(std::isinf(positionIndex(eye, direction(1.95, 0))));
  EXPECT_TRUE(std::isinf(positionIndex(eye, direction(0, 3.1))));
  EXPECT_EQ(positionIndex(eye, direction(0.4, 0.3)), positionIndex(eye, direction(0.4, -0.3)));
  EXPECT_DOUBLE_EQ(positionIndex(eye, direction(-0.5, 0)), 1.4);
  EXPECT_NEAR(positionIndex(eye, direction(-1, 0)), 2.2, 1e-12);
  EXPECT_NEAR(positionIndex(eye, direction(-9, 0)), 4.6, 1e-12);
  EXPECT_TRUE(std::isinf(positionIndex(eye, {0, -1, 0.1})));
}

TEST(GlareRating, PanelIsLuminanceSquaredTimesSolidAngle)
{
  kalos::SceneDescription scene;
  scene.luminaires.push_back(panel({0.5, 3, 2.7}, 0.6, 3000));
  const GlareSum glare = glareSum(kalos::Scene(scene), eye);
  const Vec3 d{0.5, 3, 1.5};
  const double d2 = kalos::dot(d, d), cosine = 1.5 / std::sqrt(d2);
  const double luminance = 3000 / (pi * 0.36), omega = 0.36 * cosine / d2;
  const double p = positionIndex(eye, kalos::normalized(d));
  EXPECT_NEAR(glare.sum, luminance * luminance * omega / (p * p), 1e-9 * glare.sum);
  EXPECT_EQ(glare.sources, 1);
  EXPECT_EQ(glare.small, 0);
  EXPECT_EQ(glare.large, 0);
  // 30 cd/m2 of background; worked by hand: 8 log10(0.25 / 30 x sum).
  EXPECT_NEAR(kalos::unifiedGlareRating(glare.sum, 30 * pi), 8 * std::log10(0.25 / 30 * glare.sum), 1e-12);
}

TEST(GlareRating, PointsCountAsSmallSources)
{
  kalos::SceneDescription scene;
  kalos::Luminaire lamp;
  lamp.position = {0, 2, 1.2};
  lamp.flux = 4 * pi * 50;
  lamp.distribution = kalos::Distribution::Isotropic;
  scene.luminaires.push_back(lamp);
  const GlareSum glare = glareSum(kalos::Scene(scene), eye);
  EXPECT_NEAR(glare.sum, 200 * 50 * 50 / 4.0, 1e-9 * glare.sum);
  EXPECT_EQ(glare.small, 1);
}

TEST(GlareRating, WhatIsHiddenOrBehindDoesNotGlare)
{
  kalos::SceneDescription scene;
  scene.luminaires.push_back(panel({0, 3, 2.7}, 0.6, 3000));
  const double whole = glareSum(kalos::Scene(scene), eye).sum;
  const std::uint32_t black = rooms::addMaterial(scene, 0);
  rooms::addQuad(scene, {-5, 1, 0}, {5, 0, 0}, {0, 0, 5}, black);  // hides x < 0
  EXPECT_NEAR(glareSum(kalos::Scene(scene), eye).sum, whole / 2, 1e-9 * whole);
  rooms::addQuad(scene, {0, 1, 0}, {5, 0, 0}, {0, 0, 5}, black);
  EXPECT_EQ(glareSum(kalos::Scene(scene), eye).sources, 0);
  scene.triangles.clear();
  scene.triangleMaterial.clear();
  scene.luminaires[0].position = {0, -3, 2.7};
  EXPECT_EQ(glareSum(kalos::Scene(scene), eye).sum, 0);
  EXPECT_TRUE(std::isinf(kalos::unifiedGlareRating(0, 100)));
  EXPECT_TRUE(std::isnan(kalos::unifiedGlareRating(1, 0)));
}

TEST(GlareRating, EmittingSurfacesAreThePanelTheyLookLike)
{
  kalos::SceneDescription lit, emits;
  lit.luminaires.push_back(panel({0, 6, 2.7}, 0.6, 3000));
  rooms::addQuad(emits, {-0.3, 5.7, 2.7}, {0, 0.6, 0}, {0.6, 0, 0}, rooms::addMaterial(emits, 0.5, 3000 / 0.36));
  const double one = glareSum(kalos::Scene(lit), eye).sum, other = glareSum(kalos::Scene(emits), eye).sum;
  EXPECT_NEAR(other, one, 0.03 * one);  // the panel has one solid angle and index for all its spots
  EXPECT_EQ(glareSum(kalos::Scene(emits), {{0, 0, 3.5}, {0, 1, 0}, {0, 0, 1}}).sources, 0);  // from above: its back
}

TEST(GlareRating, ALuminousCeilingIsCutUntilItsSumSettles)
{
  // Uniform luminance L over the upper half of the field of view: the integral of 1/p^2 over a quarter sphere.
  kalos::SceneDescription scene;
  rooms::addQuad(scene, {-200, -200, 2.2}, {0, 400, 0}, {400, 0, 0}, rooms::addMaterial(scene, 0.5, pi));
  double expected = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double phi = pi * (i + 0.5) / n, z = (j + 0.5) / n, s = std::sqrt(1 - z * z);
      if (s / z > 150)  // beyond the ceiling
        continue;
      const double p = positionIndex(eye, {s * std::cos(phi), s * std::sin(phi), z});
      expected += pi / (static_cast<double>(n) * n) / (p * p);
    }
  const GlareSum glare = glareSum(kalos::Scene(scene), eye);
  EXPECT_NEAR(glare.sum, expected, 0.05 * expected);
  EXPECT_EQ(glare.large, 2);
}
