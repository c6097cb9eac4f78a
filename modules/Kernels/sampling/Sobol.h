// SPDX-License-Identifier: BSD-3-Clause
// The first two dimensions of Sobol's sequence, Owen-scrambled by hashing: a (0,2)-sequence in base 2, stratified in
// both dimensions and in their products, unbiased under its random scrambling (Owen 1995; hash by Laine and Karras
// 2011, with the constants of Vegdahl 2021).
#ifndef kalos_sampling_Sobol_h
#define kalos_sampling_Sobol_h

#include <cstdint>

#include "sampling/Random.h"

namespace kalos
{
inline std::uint32_t reverseBits(std::uint32_t x)
{
  x = ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}

/// Nested uniform scrambling of a 32-bit fraction.
inline std::uint32_t owenScramble(std::uint32_t x, std::uint32_t seed)
{
  x = reverseBits(x);
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return reverseBits(x);
}

/// Point `index` of the scrambled sequence that `key` selects; u1, u2 in [0,1).
inline void sobolPoint(std::uint64_t key, std::uint32_t index, double& u1, double& u2)
{
  const std::uint32_t first = reverseBits(index);
  std::uint32_t second = 0;
  for (std::uint32_t column = 0x80000000u, i = index; i; i >>= 1, column ^= column >> 1)
    if (i & 1)
      second ^= column;
  const std::uint64_t seeds = mixBits(key);
  u1 = owenScramble(first, static_cast<std::uint32_t>(seeds)) * 0x1.0p-32;
  u2 = owenScramble(second, static_cast<std::uint32_t>(seeds >> 32)) * 0x1.0p-32;
}
}  // namespace kalos

#endif
