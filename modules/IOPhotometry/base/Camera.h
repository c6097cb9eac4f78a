// SPDX-License-Identifier: BSD-3-Clause
/** Cameras and lines of sight of scenes and models. */
#ifndef KalosCamera_h
#define KalosCamera_h

#include <array>
#include <string>

#include "Vectors.h"

namespace kalos::scene
{
struct Sight
{
  Vector3 position{};         ///< m
  Vector3 target{};           ///< m
  Vector3 up{0.0, 0.0, 1.0};  ///< any length
};

struct Camera : Sight
{
  std::string name;
  double fieldOfView = 45.0;        ///< vertical, degrees
  std::array<int, 2> resolution{};  ///< pixels, width and height
};
}  // namespace kalos::scene

#endif
