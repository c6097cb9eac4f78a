// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/Tally.h"

namespace kalos
{
MeanAndError Tally::summary(std::size_t receiver, long long n) const
{
  const double fixed = photometric(&this->Fixed[receiver * this->BandCount], this->BandCount);
  std::vector<double> estimates(this->Replicates);
  for (int p = 0; p < this->Replicates; ++p)
    estimates[p] = fixed + photometric(&this->Total[this->at(receiver, p)], this->BandCount) / static_cast<double>(n);
  return summarise(estimates.data(), estimates.size());
}

void Tally::write(long long n, Result& result) const
{
  result.bands = this->BandCount;
  result.replicates = this->Replicates;
  result.illuminance.resize(this->Receivers);
  result.standardError.resize(this->Receivers);
  result.direct.resize(this->Receivers);
  result.illuminanceBands.resize(this->Receivers * this->BandCount);
  const double samples = static_cast<double>(n) * this->Replicates;
  for (std::size_t r = 0; r < this->Receivers; ++r)
  {
    const MeanAndError m = this->summary(r, n);
    result.illuminance[r] = m.mean;
    result.standardError[r] = m.standardError;
    double direct = 0;
    for (int b = 0; b < this->BandCount; ++b)
    {
      double total = 0, first = 0;
      for (int p = 0; p < this->Replicates; ++p)
      {
        total += this->Total[this->at(r, p) + b];
        first += this->DirectPart[this->at(r, p) + b];
      }
      const double fixed = this->Fixed[r * this->BandCount + b];
      result.illuminanceBands[r * this->BandCount + b] = fixed + total / samples;
      direct += bandShare(b, this->BandCount) * (fixed + first / samples);
    }
    result.direct[r] = direct;
  }
}
}  // namespace kalos
