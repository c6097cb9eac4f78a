// SPDX-License-Identifier: BSD-3-Clause
// Random numbers keyed by what they are for, never by who draws them: the same (seed, replicate, purpose, index) gives
// the same sequence on any thread, in any order, on any machine.
#ifndef kalos_sampling_Random_h
#define kalos_sampling_Random_h

#include <cstdint>

namespace kalos
{
/// What a stream of random numbers is for; streams of different purpose are independent.
enum class Purpose : std::uint64_t
{
  Trajectory = 1,
  DirectLight = 2,
  Gather = 3,
  Averaging = 4,
  Selection = 5,
  CameraRay = 6,
  Highlight = 7
};

/// A bijection of 64-bit words with full avalanche (Stafford's variant 13 of the MurmurHash3 finaliser).
inline std::uint64_t mixBits(std::uint64_t z)
{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// Uniform numbers in [0,1), one per dimension: u_i = hash(key, i).
class RandomStream
{
public:
  RandomStream(std::uint64_t seed, std::uint64_t replicate, Purpose purpose, std::uint64_t index)
      : Key(mixBits(mixBits(mixBits(seed + step) + replicate * step + static_cast<std::uint64_t>(purpose)) +
                    index * step))
  {
  }

  double next()
  {
    this->Key += step;
    return static_cast<double>(mixBits(this->Key) >> 11) * 0x1.0p-53;
  }

private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15ull;  // 2^64 / golden ratio, odd
  std::uint64_t Key;
};
}  // namespace kalos

#endif
