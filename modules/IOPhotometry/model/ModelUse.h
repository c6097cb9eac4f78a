// SPDX-License-Identifier: BSD-3-Clause
/** How a model file is taken into a scene. */
#ifndef KalosModelUse_h
#define KalosModelUse_h

#include "../mesh/Transform.h"
#include "Model.h"

namespace kalos::scene
{
struct ModelUse
{
  Transform place;                       ///< from the file's coordinates to metres with z up
  const Materials* overrides = nullptr;  ///< by name, before the file's own
  const Material* fallback = nullptr;    ///< of polygons without a material; UnnamedReflectance if null
};

constexpr double UnnamedReflectance = 0.5;  ///< diffuse, of polygons without any material
constexpr const char* UnnamedSubject = "surfaces without a material";
constexpr const char* UnnamedChoice = "reflectance 0.5";
constexpr const char* UnnamedReason = "the file gives none";
}  // namespace kalos::scene

#endif
