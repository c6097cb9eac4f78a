// SPDX-License-Identifier: BSD-3-Clause
/** Latitude-longitude pictures of skies. */
#ifndef KalosSkyPicture_h
#define KalosSkyPicture_h

#include <string>

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

namespace kalos
{
/**
 * The luminance of an OpenEXR image (channel Y, or R, G and B, cd/m²) or of a Radiance picture (179 times its
 * luminance), a tuple per row from the top. Throws std::runtime_error for a file that is neither.
 */
vtkSmartPointer<vtkFloatArray> readSkyPicture(const std::string& path);
}  // namespace kalos

#endif
