// SPDX-License-Identifier: BSD-3-Clause
/// What the conversions of surfaces and of luminaires share.
#ifndef ConversionErrors_h
#define ConversionErrors_h

#include <stdexcept>
#include <string>

#include "geometry/Vector.h"
#include "vtkType.h"

/// Throws with the place of a value that cannot be.
[[noreturn]] inline void Refuse(const char* array, const char* what, vtkIdType i, const std::string& expected)
{
  throw std::invalid_argument(std::string(array) + " of " + what + " " + std::to_string(i) + ": " + expected);
}

inline kalos::Vec3 ToVec3(const double v[3])
{
  return {v[0], v[1], v[2]};
}

#endif
