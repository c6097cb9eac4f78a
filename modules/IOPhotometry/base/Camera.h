// SPDX-License-Identifier: BSD-3-Clause
/** Cameras, and where an eye looks, as scenes and models give them. */
#ifndef KalosCamera_h
#define KalosCamera_h

#include <array>
#include <string>

#include "Vectors.h"

namespace kalos::scene
{
struct Sight
{
  Vector3 Position{};         ///< m
  Vector3 Target{};           ///< m
  Vector3 Up{0.0, 0.0, 1.0};  ///< any length
};

struct Camera : Sight
{
  std::string Name;
  double FieldOfView = 45.0;        ///< vertical, degrees
  std::array<int, 2> Resolution{};  ///< pixels, width and height
};
}  // namespace kalos::scene

#endif
