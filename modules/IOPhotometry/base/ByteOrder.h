// SPDX-License-Identifier: BSD-3-Clause
/** Reads numbers from the bytes of a file in the given byte order, on any machine. */
#ifndef KalosByteOrder_h
#define KalosByteOrder_h

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace kalos::scene
{
enum class ByteOrder
{
  LittleEndian,
  BigEndian
};

template <typename T>
T fromBytes(const void* bytes, ByteOrder order = ByteOrder::LittleEndian)
{
  unsigned char own[sizeof(T)];
  std::memcpy(own, bytes, sizeof(T));
  const std::uint16_t one = 1;
  const bool machineIsBig = *reinterpret_cast<const unsigned char*>(&one) == 0;
  if ((order == ByteOrder::BigEndian) != machineIsBig)
  {
    std::reverse(own, own + sizeof(T));
  }
  T value;
  std::memcpy(&value, own, sizeof(T));
  return value;
}
}  // namespace kalos::scene

#endif
