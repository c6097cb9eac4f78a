// SPDX-License-Identifier: BSD-3-Clause
/** The mean colour of an image: what Kalos takes of a texture. */
#ifndef KalosAverageColor_h
#define KalosAverageColor_h

#include <array>
#include <optional>
#include <string>

namespace kalos::scene
{
struct AverageColor
{
  std::array<double, 3> linear{};   ///< mean of the sRGB pixels in linear light, [0,1]
  std::array<double, 3> encoded{};  ///< mean of the pixels without decoding, [0,1], for textures that hold no colours
};

/** Of a PNG or JPEG image in memory; none for other formats and damaged images, the reason in `problem`. */
std::optional<AverageColor> readAverageColor(const unsigned char* data, std::size_t size, std::string& problem);
}  // namespace kalos::scene

#endif
