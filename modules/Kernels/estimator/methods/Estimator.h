// SPDX-License-Identifier: BSD-3-Clause
// The one interface of all methods: add a round of trajectories of every replicate to a tally.
#ifndef kalos_estimator_methods_Estimator_h
#define kalos_estimator_methods_Estimator_h

#include <memory>

#include "estimator/control/Receivers.h"
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"
#include "estimator/control/Workers.h"
#include "estimator/tally/Tally.h"
#include "scene/Scene.h"

namespace kalos
{
/// How a method goes through its trajectories.
struct Pace
{
  int multiple = 1;    ///< rounds are multiples of so many trajectories of a replicate, but for the last
  int smallest = 256;  ///< trajectories of a replicate that a round may always have
  double work = 1;     ///< at a receiver per trajectory, in scores of a trajectory's vertices
};

class Estimator
{
public:
  virtual ~Estimator() = default;

  /// Work that does not depend on trajectories (exact direct light). Returns false when aborted.
  virtual bool prepare(Workers& workers, Tally& tally) = 0;

  /// Adds the scores of trajectories [first, first + count) of every replicate, each as if its trajectory were the only
  /// one. Returns false when aborted, which leaves the tally without meaning.
  virtual bool addRound(long long first, int count, Workers& workers, Tally& tally) = 0;

  /// Fetches from every rank what audit() needs of the replicates that it owns.
  virtual void exchange(const Ranks&) {}

  /// Saves or restores what addRound() carries from round to round; after exchangeState(), so that a checkpoint serves
  /// any number of ranks.
  virtual void persist(Archive&) {}

  /// Fetches from every rank the part of that state that it owns.
  virtual void exchangeState(const Ranks&) {}

  /// Whether `trajectories` (over all replicates) suffice to see what surrounds a receiver; rule (2) of
  /// estimator/tally/IntervalDiagnostics.h.
  virtual bool trusts(std::size_t /*receiver*/, long long /*trajectories*/) const { return true; }

  /// Gather rays that each receiver has sent, over all replicates and ranks; empty where none of a method's are
  /// counted.
  virtual std::vector<double> gatherRays() const { return {}; }

  /// Independent replicates to run for `trajectories`, over all of them.
  virtual int replicates(long long trajectories) const { return replicateCount(trajectories); }

  /// Whether addRound() skips receivers that rest.
  virtual bool skipsConverged() const { return false; }

  virtual Pace pace() const { return {}; }

  /// Whether Tally::correction() means something.
  virtual bool altersKernel() const { return false; }

  /// What the method found it need not model, and why.
  virtual std::vector<AuditLine> audit() const = 0;
};
}  // namespace kalos

#endif
