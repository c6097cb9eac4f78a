// SPDX-License-Identifier: BSD-3-Clause
// The first four dimensions of Sobol's sequence, Owen-scrambled by hashing: the first two are a (0,2)-sequence in base
// 2, stratified in both dimensions and in their products; unbiased under random scrambling (Owen 1995; hash by Laine
// and Karras 2011, with the constants of Vegdahl 2021).
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

/// Columns of the generator matrices of the first four dimensions (Joe and Kuo 2008), as 32-bit fractions.
struct SobolColumns
{
  static constexpr int dimensions = 4;
  std::uint32_t column[32][dimensions] = {};

  constexpr SobolColumns()
  {
    constexpr int degree[] = {0, 1, 2, 3}, coefficients[] = {0, 0, 1, 1};
    constexpr std::uint32_t initial[][3] = {{0, 0, 0}, {1, 0, 0}, {1, 3, 0}, {1, 3, 1}};
    for (int d = 0; d < dimensions; ++d)
      for (int i = 0; i < 32; ++i)
      {
        const int s = degree[d];
        std::uint32_t v = 0;
        if (d == 0)
          v = 0x80000000u >> i;
        else if (i < s)
          v = initial[d][i] << (31 - i);
        else
        {
          v = this->column[i - s][d] ^ (this->column[i - s][d] >> s);
          for (int k = 1; k < s; ++k)
            if ((coefficients[d] >> (s - 1 - k)) & 1)
              v ^= this->column[i - k][d];
        }
        this->column[i][d] = v;
      }
  }
};
inline constexpr SobolColumns sobolColumns{};

/// The first `dimensions` coordinates, at most four, of point `index`, not scrambled, as 32-bit fractions.
inline void sobolBits(std::uint32_t index, int dimensions, std::uint32_t* bits)
{
  for (int d = 0; d < dimensions; ++d)
    bits[d] = 0;
  for (int i = 0; index; index >>= 1, ++i)
    if (index & 1)
      for (int d = 0; d < dimensions; ++d)
        bits[d] ^= sobolColumns.column[i][d];
}

/// Point `index` of the scrambled sequence that `key` selects; u1, u2 in [0,1).
inline void sobolPoint(std::uint64_t key, std::uint32_t index, double& u1, double& u2)
{
  std::uint32_t bits[2];
  sobolBits(index, 2, bits);
  const std::uint64_t seeds = mixBits(key);
  u1 = owenScramble(bits[0], static_cast<std::uint32_t>(seeds)) * 0x1.0p-32;
  u2 = owenScramble(bits[1], static_cast<std::uint32_t>(seeds >> 32)) * 0x1.0p-32;
}
}  // namespace kalos

#endif
