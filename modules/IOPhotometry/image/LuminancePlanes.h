// SPDX-License-Identifier: BSD-3-Clause
/** The channels of a luminance image, checked, as writers of images want them. */
#ifndef KalosLuminancePlanes_h
#define KalosLuminancePlanes_h

#include <string>
#include <vector>

class vtkImageData;

namespace kalos
{
/** One channel: its samples, cd/m², from the top row down. */
struct Plane
{
  std::string channel;
  std::vector<float> samples;
};

/**
 * `R`, `G` and `B` from LuminanceBands of three components, else `Y` from Luminance; and `Y.standardError`. Throws
 * std::invalid_argument for an image of other arrays, and at the first value that is no luminance, with its pixel.
 */
std::vector<Plane> makePlanes(vtkImageData* image);
}  // namespace kalos

#endif
