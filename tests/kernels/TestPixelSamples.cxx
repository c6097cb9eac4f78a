// SPDX-License-Identifier: BSD-3-Clause
// Anti-aliasing: pixels beside edges are the mean over their footprint.
#include <gtest/gtest.h>

#include "Rooms.h"
#include "estimator/quantities/LuminanceImage.h"

using namespace kalos;

namespace
{
// Four pixels of 0.5 m across, on the plane y = 1, where all x below 0.2 m shine: 40 % of the third column.
LuminanceResult imageOfHalfPlane(int samples)
{
  SceneDescription d;
  rooms::addQuad(d, {-5, 1, -5}, {5.2, 0, 0}, {0, 0, 10}, rooms::addMaterial(d, 0, 1000));
  Camera camera;
  camera.position = {0, 0, 0};
  camera.target = {0, 1, 0};
  camera.fieldOfView = 90;
  camera.width = camera.height = 4;
  camera.pixelSamples = samples;
  Settings s;
  s.trajectories = 320;
  return solveLuminance(Scene(d), camera, s);
}
}  // namespace

// Sixteen stratified samples find a straight edge to one of them.
TEST(PixelSamples, EdgesAreTheShareThatTheyCover)
{
  const LuminanceResult image = imageOfHalfPlane(16);
  for (const std::size_t row : {0, 1, 2, 3})
  {
    EXPECT_NEAR(image.luminance[4 * row], 1000 / pi, 1e-9);
    EXPECT_NEAR(image.luminance[4 * row + 1], 1000 / pi, 1e-9);
    EXPECT_NEAR(image.luminance[4 * row + 2], 0.4 * 1000 / pi, 1000 / pi / 16);
    EXPECT_EQ(image.luminance[4 * row + 3], 0);
  }
}

TEST(PixelSamples, OneIsTheCentre)
{
  const LuminanceResult image = imageOfHalfPlane(1);
  EXPECT_NEAR(image.luminance[1], 1000 / pi, 1e-9);
  EXPECT_EQ(image.luminance[2], 0);
}

TEST(PixelSamples, AreCounted)
{
  for (const int wrong : {0, 257})
    EXPECT_THROW(imageOfHalfPlane(wrong), std::invalid_argument);
}
