// SPDX-License-Identifier: BSD-3-Clause
/** The lights that a model brings. */
#ifndef KalosModelLight_h
#define KalosModelLight_h

#include <string>

#include "../base/Vectors.h"

namespace kalos::scene
{
/** A light of KHR_lights_punctual. */
struct ModelLight
{
  enum class Kind
  {
    Point,    ///< Strength is the intensity, cd
    Spot,     ///< Strength is the intensity in the middle, cd
    Parallel  ///< Strength is the illuminance across the rays, lx
  };

  std::string name;
  Kind type = Kind::Point;
  double strength = 0.0;
  double innerAngle = 0.0;  ///< of a spot, from the aim to where it begins to fade, rad
  double outerAngle = 0.0;  ///< of a spot, to where it is dark, rad
  Vector3 position{};       ///< m
  Vector3 aim{};            ///< unit vector
};
}  // namespace kalos::scene

#endif
