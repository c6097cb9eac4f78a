// SPDX-License-Identifier: BSD-3-Clause
#include "AverageColor.h"

#include <png.h>
#include <turbojpeg.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

namespace kalos::scene
{
namespace
{
constexpr double MaximumPixels = 1e8;

/** Red, green and blue, 8 bits each. */
using Pixels = std::vector<unsigned char>;

bool decodePng(const unsigned char* data, std::size_t size, Pixels& pixels, std::string& problem)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> owner(&image, png_image_free);
  if (!png_image_begin_read_from_memory(&image, data, size))
  {
    problem = image.message;
    return false;
  }
  if (static_cast<double>(image.width) * image.height > MaximumPixels)
  {
    problem = "it has more than 10^8 pixels";
    return false;
  }
  // Alpha is cut off, not blended with a background.
  image.format = PNG_FORMAT_RGBA;
  Pixels withAlpha(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, withAlpha.data(), 0, nullptr))
  {
    problem = image.message;
    return false;
  }
  for (std::size_t i = 0; i + 3 < withAlpha.size(); i += 4)
  {
    pixels.insert(pixels.end(), &withAlpha[i], &withAlpha[i] + 3);
  }
  return true;
}

bool decodeJpeg(const unsigned char* data, std::size_t size, Pixels& pixels, std::string& problem)
{
  const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
  int width = 0, height = 0, sampling = 0, space = 0;
  if (tjDecompressHeader3(decoder.get(), data, size, &width, &height, &sampling, &space) != 0)
  {
    problem = tjGetErrorStr2(decoder.get());
    return false;
  }
  if (static_cast<double>(width) * height > MaximumPixels)
  {
    problem = "it has more than 10^8 pixels";
    return false;
  }
  pixels.resize(std::size_t{3} * width * height);
  if (tjDecompress2(decoder.get(), data, size, pixels.data(), width, 0, height, TJPF_RGB, 0) != 0)
  {
    problem = tjGetErrorStr2(decoder.get());
    return false;
  }
  return true;
}

/** IEC 61966-2-1. */
double linearOf(double encoded)
{
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
}  // namespace

std::optional<AverageColor> readAverageColor(const unsigned char* data, std::size_t size, std::string& problem)
{
  Pixels pixels;
  const bool png = size > 8 && std::memcmp(data, "\x89PNG", 4) == 0;
  const bool jpeg = size > 8 && data[0] == 0xFF && data[1] == 0xD8;
  if (!png && !jpeg)
  {
    problem = "it is neither PNG nor JPEG";
    return {};
  }
  if (!(png ? decodePng : decodeJpeg)(data, size, pixels, problem) || pixels.empty())
  {
    return {};
  }
  std::array<std::array<std::size_t, 256>, 3> counts{};
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    ++counts[i % 3][pixels[i]];
  }
  AverageColor average;
  for (int c = 0; c < 3; ++c)
  {
    for (int value = 0; value < 256; ++value)
    {
      const double share = static_cast<double>(counts[c][value]) / (static_cast<double>(pixels.size()) / 3.0);
      average.encoded[c] += share * value / 255.0;
      average.linear[c] += share * linearOf(value / 255.0);
    }
  }
  return average;
}
}  // namespace kalos::scene
