// SPDX-License-Identifier: BSD-3-Clause
/** The header of a PLY file: what its elements are, and in which form their numbers stand. */
#ifndef KalosPlyHeader_h
#define KalosPlyHeader_h

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "../base/ByteOrder.h"

namespace kalos::scene
{
enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
  None
};

struct PlyProperty
{
  std::string name;
  PlyType item = PlyType::None;
  PlyType count = PlyType::None;  ///< of a list; None for a scalar
};

struct PlyElement
{
  std::string name;
  std::int64_t size = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  bool ascii = false;
  ByteOrder order = ByteOrder::LittleEndian;
  std::vector<PlyElement> elements;
};

/** Read up to the line end_header; `path` is for messages. */
PlyHeader readPlyHeader(std::istream& file, const std::string& path);
}  // namespace kalos::scene

#endif
