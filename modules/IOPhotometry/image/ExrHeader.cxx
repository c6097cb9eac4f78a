// SPDX-License-Identifier: BSD-3-Clause
#include "ExrHeader.h"

#include <OpenEXR/ImfCompression.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "../base/ByteOrder.h"

namespace kalos
{
namespace
{
constexpr double MostPixelsPerByte = 16384.0;  // black images of the tightest compression stay below
constexpr double LinesAtOnce = 32.0;           // OpenEXR makes room for such a block whatever the height
constexpr double MostTilePixels = 1 << 24;
constexpr std::uint32_t MultiPart = 0x1000;

std::uint32_t readWord(std::istream& file)
{
  unsigned char bytes[4] = {0, 0, 0, 0};
  file.read(reinterpret_cast<char*>(bytes), 4);
  return scene::fromBytes<std::uint32_t>(bytes);
}
/** The difference of two signed coordinates and 1, as the sides of a window count. */
double side(std::uint32_t low, std::uint32_t high)
{
  return static_cast<double>(static_cast<std::int32_t>(high)) - static_cast<std::int32_t>(low) + 1.0;
}

/** Reads the value of an attribute that sizes memory; empty if the size is good. */
std::string checkSize(const std::string& name, std::istream& file, double mostPixels, double fileBytes)
{
  if (name == "dataWindow")
  {
    const std::uint32_t x0 = readWord(file), y0 = readWord(file), x1 = readWord(file), y1 = readWord(file);
    const double width = side(x0, x1), height = side(y0, y1);
    if (!(width >= 1.0 && height >= 1.0 && width * height <= mostPixels))
    {
      return "the data window is empty or too large; expected 1 to " +
             std::to_string(static_cast<long long>(mostPixels)) + " pixels";
    }
    if (width * std::max(height, LinesAtOnce) > MostPixelsPerByte * fileBytes)
    {
      return "more pixels than the file can hold; expected a complete OpenEXR image";
    }
  }
  if (name == "compression")
  {
    const int method = file.get();
    if (method >= Imf::NUM_COMPRESSION_METHODS)
    {
      return "the compression of number " + std::to_string(method) +
             " is newer than this OpenEXR; expected a file written with ZIP, PIZ, PXR24, B44, DWA or none";
    }
  }
  if (name == "tiles")
  {
    const double width = readWord(file), height = readWord(file);
    if (!(width >= 1.0 && height >= 1.0 && width * height <= MostTilePixels))
    {
      return "tiles that are empty or too large; expected 1 to " + std::to_string(static_cast<int>(MostTilePixels)) +
             " pixels each";
    }
  }
  return {};
}
}  // namespace

std::string checkExrHeader(const std::string& path, double mostPixels)
{
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  std::ifstream file(path, std::ios::binary);
  readWord(file);
  const bool several = (readWord(file) & MultiPart) != 0;
  std::string name, type;
  bool first = true;  // attribute of its header
  bool windowed = false;
  while (std::getline(file, name, '\0'))
  {
    if (name.empty())
    {
      if (!first && !windowed)
      {
        return "no data window; expected a complete OpenEXR image";
      }
      if (first || !several)
      {
        return {};
      }
      first = true;
      windowed = false;
      continue;
    }
    first = false;
    windowed = windowed || name == "dataWindow";
    std::getline(file, type, '\0');
    const std::uint32_t bytes = readWord(file);
    const auto here = static_cast<std::uintmax_t>(file ? static_cast<std::streamoff>(file.tellg()) : -1);
    if (!file || bytes > size - here)
    {
      return "an attribute ends beyond the file; expected a complete OpenEXR image";
    }
    const auto next = file.tellg() + static_cast<std::streamoff>(bytes);
    const std::string problem = checkSize(name, file, mostPixels, static_cast<double>(size));
    if (!problem.empty())
    {
      return problem;
    }
    file.clear();
    file.seekg(next);
  }
  return "the file ends within it; expected a complete OpenEXR image";
}

}  // namespace kalos
