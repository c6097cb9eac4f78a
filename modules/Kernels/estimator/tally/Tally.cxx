// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/Tally.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kalos
{
Tally::Tally(const Scene& scene, std::size_t receivers, int replicates)
    : Receivers(receivers),
      Replicates(replicates),
      BandCount(scene.bands()),
      Energy(scene, replicates),
      Fixed(receivers * BandCount),
      Total(receivers * replicates * BandCount),
      Direct(receivers * replicates * BandCount),
      Correction(receivers * replicates),
      Largest(receivers * replicates),
      Picked(receivers * replicates),
      Converged(receivers),
      Missed(receivers),
      Active(receivers)
{
}

void Tally::exchange(const Ranks& ranks)
{
  this->Energy.exchange(ranks);
  ranks.exchange(this->Replicates, [this](int first, int last, const auto& visit) {
    for (std::size_t r = 0; r < this->Receivers; ++r)
      for (std::size_t i = r * this->Replicates + first; i < r * this->Replicates + last; ++i)
      {
        visit(this->Correction[i]);
        visit(this->Largest[i]);
        for (double* value : {&this->Picked[i].possible, &this->Picked[i].tried, &this->Picked[i].seen})
          visit(*value);
        for (std::size_t b = i * this->BandCount; b < (i + 1) * this->BandCount; ++b)
        {
          visit(this->Total[b]);
          visit(this->Direct[b]);
        }
      }
  });
}

void Tally::setConverged(std::vector<char> receivers)
{
  this->Converged = std::move(receivers);
  this->Active = static_cast<std::size_t>(std::count(this->Converged.begin(), this->Converged.end(), 0));
}

void Tally::keepConverged(long long first, int count)
{
  // Sums are divided by all trajectories, so scale them as if the skipped ones had scored like those before.
  const double grown = static_cast<double>(first + count) / static_cast<double>(first);
  for (std::size_t r = 0; r < this->Receivers; ++r)
  {
    if (!this->converged(r))
      continue;
    this->Missed[r] += count;
    for (int p = 0; p < this->Replicates; ++p)
    {
      const std::size_t i = r * this->Replicates + p;
      this->Correction[i] *= grown;
      this->Largest[i] *= grown;
      this->Picked[i].possible *= grown;
      for (int b = 0; b < this->BandCount; ++b)
      {
        this->total(r, p)[b] *= grown;
        this->direct(r, p)[b] *= grown;
      }
    }
  }
}

bool Tally::sound(std::size_t receiver, int replicate) const
{
  const std::size_t i = this->at(receiver, replicate);
  bool finite = std::isfinite(this->Largest[receiver * this->Replicates + replicate]);
  for (int b = 0; b < this->BandCount; ++b)
    finite = finite && std::isfinite(this->Total[i + b]) && std::isfinite(this->Direct[i + b]) &&
             std::isfinite(this->Fixed[receiver * this->BandCount + b]);
  return finite;
}

void Tally::persist(Archive& archive)
{
  for (std::vector<double>* sums : {&this->Fixed, &this->Total, &this->Direct, &this->Correction, &this->Largest})
    archive.array(*sums);
  archive.array(this->Picked);
  archive.array(this->Missed);
  this->Energy.persist(archive);
}

std::vector<double> Tally::estimates(std::size_t receiver, long long n, bool indirectOnly) const
{
  const double fixed = indirectOnly ? 0 : photometric(&this->Fixed[receiver * this->BandCount], this->BandCount);
  std::vector<double> all(this->Replicates);
  for (int p = 0; p < this->Replicates; ++p)
  {
    const std::size_t i = this->at(receiver, p);
    const double direct = indirectOnly ? photometric(&this->Direct[i], this->BandCount) : 0;
    all[p] = fixed + (photometric(&this->Total[i], this->BandCount) - direct) / static_cast<double>(n);
  }
  return all;
}

MeanAndError Tally::summary(std::size_t receiver, long long n) const
{
  const std::vector<double> all = this->estimates(receiver, n);
  return summarise(all.data(), all.size());
}

double Tally::largestShare(std::size_t receiver, long long n) const
{
  const auto first = this->Largest.begin() + static_cast<std::ptrdiff_t>(receiver * this->Replicates);
  const double largest = *std::max_element(first, first + this->Replicates);
  const double sum = this->summary(receiver, n).mean * static_cast<double>(n) * this->Replicates;
  return sum > 0 ? std::min(1.0, largest / sum) : 0;
}

PickCount Tally::picks(std::size_t receiver) const
{
  PickCount all;
  for (int p = 0; p < this->Replicates; ++p)
    all.add(this->Picked[receiver * this->Replicates + p]);
  return all;
}

bool Tally::largestStandsOut(std::size_t receiver) const
{
  const auto first = this->Largest.begin() + static_cast<std::ptrdiff_t>(receiver * this->Replicates);
  std::vector<double> largest(first, first + this->Replicates);
  std::sort(largest.begin(), largest.end());
  return this->Replicates < 8 || largest.back() > 3 * largest[largest.size() / 2];
}

void Tally::write(long long n, Result& result) const
{
  result.bands = this->BandCount;
  result.replicates = this->Replicates;
  result.illuminance.resize(this->Receivers);
  result.standardError.resize(this->Receivers);
  result.direct.resize(this->Receivers);
  result.indirectError.resize(this->Receivers);
  result.kernelCorrection.resize(this->Receivers);
  result.largestScoreShare.resize(this->Receivers);
  result.illuminanceBands.resize(this->Receivers * this->BandCount);
  const double samples = static_cast<double>(n) * this->Replicates;
  for (std::size_t r = 0; r < this->Receivers; ++r)
  {
    const MeanAndError m = this->summary(r, n);
    result.illuminance[r] = m.mean;
    result.standardError[r] = m.standardError;
    const std::vector<double> indirect = this->estimates(r, n, true);
    result.indirectError[r] = summarise(indirect.data(), indirect.size()).standardError;
    result.largestScoreShare[r] = this->largestShare(r, n);
    const auto correction = this->Correction.begin() + static_cast<std::ptrdiff_t>(r * this->Replicates);
    result.kernelCorrection[r] = std::accumulate(correction, correction + this->Replicates, 0.0) / samples;
    double direct = 0;
    for (int b = 0; b < this->BandCount; ++b)
    {
      double total = 0, first = 0;
      for (int p = 0; p < this->Replicates; ++p)
      {
        total += this->Total[this->at(r, p) + b];
        first += this->Direct[this->at(r, p) + b];
      }
      const double fixed = this->Fixed[r * this->BandCount + b];
      result.illuminanceBands[r * this->BandCount + b] = fixed + total / samples;
      direct += bandShare(b, this->BandCount) * (fixed + first / samples);
    }
    result.direct[r] = direct;
  }
}
}  // namespace kalos
