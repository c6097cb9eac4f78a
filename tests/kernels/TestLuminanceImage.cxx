// SPDX-License-Identifier: BSD-3-Clause
// Images of luminance.
#include <gtest/gtest.h>

#include "FloorPoints.h"
#include "estimator/quantities/LuminanceImage.h"

using namespace kalos;

// L = rho E/pi + M0/pi in the furnace, for every pixel away from edges.
TEST(LuminanceImage, Furnace)
{
  const Scene scene(rooms::furnace(0.6, 100));
  Camera camera;
  camera.position = {2.5, 0.3, 2.6};
  camera.target = {2.5, 5, 3.6};
  camera.fieldOfView = 20;
  camera.width = camera.height = 5;
  const LuminanceResult image = solveLuminance(scene, camera, quick(Method::Local, 32000));
  const double truth = (0.6 * 250 + 100) / pi;
  for (std::size_t i = 0; i < image.luminance.size(); ++i)
  {
    EXPECT_LT(std::abs(image.luminance[i] - truth), 4.9 * image.standardError[i]);  // Sidak for 25, false alarm 1e-3
    EXPECT_LT(image.standardError[i], 0.1 * truth);
  }
}

TEST(LuminanceImage, RefusesCamerasInsideOut)
{
  const Scene scene(rooms::litRoom(0.5));
  auto message = [&](auto change) -> std::string {
    Camera camera;
    camera.position = {2.5, 0.3, 2.6};
    camera.target = {2.5, 5, 2.6};
    change(camera);
    try
    {
      solveLuminance(scene, camera, quick());
      return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  EXPECT_EQ(message([](Camera& c) { c.fieldOfView = 180; }),
            "camera: the field of view must lie between 0 and 180 degrees");
  EXPECT_EQ(message([](Camera& c) { c.width = 0; }), "camera: the resolution must be at least 1 x 1");
  EXPECT_EQ(message([](Camera& c) { c.target = c.position; }), "camera: position and target must differ");
  EXPECT_EQ(message([](Camera& c) { c.up = {0, 1, 0}; }), "camera: up must not be parallel to the line of sight");
  EXPECT_EQ(message([](Camera& c) { c.up.x = NAN; }), "camera: coordinates must be finite");
}
