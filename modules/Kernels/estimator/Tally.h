// SPDX-License-Identifier: BSD-3-Clause
// Sums of scores per receiver, replicate and band.
#ifndef kalos_estimator_Tally_h
#define kalos_estimator_Tally_h

#include "estimator/Settings.h"
#include "photometry/Bands.h"
#include "statistics/Replicates.h"

namespace kalos
{
/// The estimate of a replicate is  fixed + sum / n  after n trajectories of that replicate.
class Tally
{
public:
  Tally(std::size_t receivers, int replicates, int bands)
      : Receivers(receivers),
        Replicates(replicates),
        BandCount(bands),
        Fixed(receivers * bands),
        Total(receivers * replicates * bands),
        DirectPart(receivers * replicates * bands)
  {
  }

  std::size_t receivers() const { return this->Receivers; }
  int replicates() const { return this->Replicates; }
  int bands() const { return this->BandCount; }

  /// bands() values each. Different receivers and replicates may be written by different threads.
  double* fixed(std::size_t receiver) { return &this->Fixed[receiver * this->BandCount]; }
  double* total(std::size_t receiver, int replicate) { return &this->Total[this->at(receiver, replicate)]; }
  double* direct(std::size_t receiver, int replicate) { return &this->DirectPart[this->at(receiver, replicate)]; }

  /// Photometric mean and standard error over the replicates, n trajectories each.
  MeanAndError summary(std::size_t receiver, long long n) const;

  /// Fills the arrays of `result`.
  void write(long long n, Result& result) const;

private:
  std::size_t at(std::size_t receiver, int replicate) const
  {
    return (receiver * this->Replicates + replicate) * this->BandCount;
  }

  std::size_t Receivers;
  int Replicates, BandCount;
  std::vector<double> Fixed, Total, DirectPart;
};
}  // namespace kalos

#endif
