// SPDX-License-Identifier: BSD-3-Clause
// The random numbers of one walk of a replicate, stratified over all walks of that replicate.
#ifndef kalos_sampling_SampleStream_h
#define kalos_sampling_SampleStream_h

#include <algorithm>

#include "sampling/Sobol.h"

namespace kalos
{
/// How the walks of one replicate depend on each other; replicates are independent always.
enum class Sampling
{
  Independent,  ///< not at all: the judge
  Sobol         ///< randomised quasi-Monte Carlo: stratified by Owen-scrambled Sobol' points
};

/// Uniform numbers in [0,1) of one walk. With Sobol the first four are a point of a sequence that all walks of the
/// replicate share: emitter, start and direction of a trajectory, or where a gather ray goes and which luminaire its
/// end asks. All others are independent: stratifying the next four or eight as well (padded sequences) changed the time
/// to an error of 1 % by less than a tenth either way, in the open and at edges.
class SampleStream
{
public:
  SampleStream(Sampling sampling, std::uint64_t seed, std::uint64_t replicate, Purpose purpose, std::uint64_t walk)
      : Low(seed, replicate, purpose, walk)
  {
    if (sampling == Sampling::Independent)
      return;
    this->Key = mixBits(mixBits(seed) + 0x9e3779b97f4a7c15ull * replicate + static_cast<std::uint64_t>(purpose));
    sobolBits(static_cast<std::uint32_t>(walk), SobolColumns::dimensions, this->Bits);
    this->Used = 0;
  }

  double next()
  {
    const double low = this->Low.next();
    if (this->Used == SobolColumns::dimensions)
      return low;
    const auto seed = static_cast<std::uint32_t>(mixBits(this->Key + this->Used) >> 32);
    // The independent number fills up the digits that a 32-bit point lacks.
    return std::min((owenScramble(this->Bits[this->Used++], seed) + low) * 0x1.0p-32, 0x1.fffffffffffffp-1);
  }

private:
  RandomStream Low;
  std::uint64_t Key = 0;
  std::uint32_t Bits[SobolColumns::dimensions];
  int Used = SobolColumns::dimensions;
};

/// Which random numbers the walks of a solve, or of one of its receivers, are made of.
struct Walks
{
  std::uint64_t seed = 1;
  Sampling sampling = Sampling::Sobol;

  SampleStream stream(int replicate, Purpose purpose, long long walk) const
  {
    return SampleStream(this->sampling, this->seed, static_cast<std::uint64_t>(replicate), purpose,
                        static_cast<std::uint64_t>(walk));
  }
  Walks ofReceiver(std::size_t receiver) const { return {mixBits(this->seed) + receiver, this->sampling}; }
};
}  // namespace kalos

#endif
