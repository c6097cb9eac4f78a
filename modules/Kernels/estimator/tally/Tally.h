// SPDX-License-Identifier: BSD-3-Clause
// Sums of scores per receiver, replicate and band.
#ifndef kalos_estimator_tally_Tally_h
#define kalos_estimator_tally_Tally_h

#include <limits>

#include "estimator/control/Archive.h"
#include "estimator/control/Ranks.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/kernel/PickCount.h"
#include "estimator/tracing/EnergyBalance.h"
#include "photometry/Bands.h"
#include "statistics/Replicates.h"

namespace kalos
{
/// The estimate of a replicate is  fixed + sum / n  after n trajectories of that replicate. Different receivers and
/// replicates may be written by different threads.
class Tally
{
public:
  Tally(const Scene& scene, std::size_t receivers, int replicates);

  std::size_t receivers() const { return this->Receivers; }
  int replicates() const { return this->Replicates; }
  int bands() const { return this->BandCount; }

  double* fixed(std::size_t receiver) { return &this->Fixed[receiver * this->BandCount]; }  ///< lx, bands() values
  double* total(std::size_t receiver, int replicate) { return &this->Total[this->at(receiver, replicate)]; }
  double* direct(std::size_t receiver, int replicate) { return &this->Direct[this->at(receiver, replicate)]; }

  /// Energy balance of the trajectories of a replicate.
  EnergySums& energy(int replicate) { return this->Energy.of(replicate); }
  template <class Pools>
  void noteEnergy(const Pools& pools)
  {
    for (std::size_t p = 0; p < pools.size(); ++p)
      this->energy(static_cast<int>(p)).add(pools[p].energy);
  }
  std::vector<AuditLine> auditEnergy() const { return this->Energy.audit(); }

  /// Luminous score of the altered kernel minus that of the plain one.
  double& correction(std::size_t receiver, int replicate)
  {
    return this->Correction[receiver * this->Replicates + replicate];
  }

  /// Notes one luminous score, in the unit of total(); a NaN or negative score invalidates the receiver permanently.
  void noteScore(std::size_t receiver, int replicate, double score)
  {
    double& largest = this->Largest[receiver * this->Replicates + replicate];
    largest = score >= 0 ? std::max(largest, score) : std::numeric_limits<double>::quiet_NaN();
  }

  /// What picks of vertices have seen, for the receiver or for what its gather rays find.
  PickCount& picks(std::size_t receiver, int replicate)
  {
    return this->Picked[receiver * this->Replicates + replicate];
  }
  PickCount picks(std::size_t receiver) const;  ///< of all replicates

  double largest(std::size_t receiver, int replicate) const
  {
    return this->Largest[receiver * this->Replicates + replicate];
  }

  /// Whether all sums are finite and no noted score was negative or NaN.
  bool sound(std::size_t receiver, int replicate) const;

  /// Fetches from every rank the sums of the replicates that it owns.
  void exchange(const Ranks& ranks);

  /// Marks (1) the receivers that reached the goal: estimators skip them in the coming rounds, and their estimates
  /// stay.
  void setConverged(std::vector<char> receivers);
  bool converged(std::size_t receiver) const { return this->Converged[receiver] != 0; }
  std::size_t active() const { return this->Active; }

  /// After a round of trajectories [first, first + count): converged receivers keep their estimate from the earlier
  /// rounds.
  void keepConverged(long long first, int count);

  /// Of n trajectories of a replicate, those that scored at the receiver.
  long long trajectories(std::size_t receiver, long long n) const { return n - this->Missed[receiver]; }

  /// Saves or restores the sums, the fixed part too.
  void persist(Archive& archive);

  /// Photometric mean and standard error over the replicates, n trajectories each.
  MeanAndError summary(std::size_t receiver, long long n) const;

  /// The photometric estimates of all replicates, n trajectories each; of the indirect part only, if `indirectOnly`.
  std::vector<double> estimates(std::size_t receiver, long long n, bool indirectOnly = false) const;

  /// Largest single score over the sum of all, in [0, 1], with what does not fluctuate counted in the sum.
  double largestShare(std::size_t receiver, long long n) const;

  /// Whether the largest score of all exceeds three times the median of the replicates' largest; always where there are
  /// too few replicates to tell.
  bool largestStandsOut(std::size_t receiver) const;

  /// Fills the arrays of `result`, but for Result::trusted.
  void write(long long n, Result& result) const;

private:
  std::size_t at(std::size_t receiver, int replicate) const
  {
    return (receiver * this->Replicates + replicate) * this->BandCount;
  }

  std::size_t Receivers;
  int Replicates, BandCount;
  EnergyBalance Energy;
  std::vector<double> Fixed, Total, Direct, Correction, Largest;
  std::vector<PickCount> Picked;
  std::vector<char> Converged;    // per receiver
  std::vector<long long> Missed;  // trajectories of a replicate that it skipped
  std::size_t Active;
};
}  // namespace kalos

#endif
