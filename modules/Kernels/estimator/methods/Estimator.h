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
/// How a method divides its trajectories into rounds.
struct Pace
{
  int multiple = 1;    ///< trajectories of a replicate in each round are a multiple of this, except in the last
  int smallest = 256;  ///< trajectories of a replicate that a round may have in any case
  double work = 1;     ///< cost of a trajectory at one receiver, in units of scoring its vertices once
};

class Estimator
{
public:
  virtual ~Estimator() = default;

  /// Does the work that does not depend on trajectories (exact direct light). Returns false when aborted.
  virtual bool prepare(Workers& workers, Tally& tally) = 0;

  /// Adds the scores of trajectories [first, first + count) of every replicate, normalized as if each trajectory were
  /// the only one. Returns false when aborted; the tally is then invalid.
  virtual bool addRound(long long first, int count, Workers& workers, Tally& tally) = 0;

  /// Fetches from every rank what audit() needs of the replicates that it owns.
  virtual void exchange(const Ranks&) {}

  /// Saves or restores the state that addRound() carries between rounds. Call after exchangeState(), so that a
  /// checkpoint works for any number of ranks.
  virtual void persist(Archive&) {}

  /// Fetches from every rank the part of that state that it owns.
  virtual void exchangeState(const Ranks&) {}

  /// Whether `trajectories` (over all replicates) suffice to sample the surroundings of a receiver; rule (2) of
  /// estimator/tally/IntervalDiagnostics.h.
  virtual bool trusts(std::size_t /*receiver*/, long long /*trajectories*/) const { return true; }

  /// Gather rays that each receiver has sent, over all replicates and ranks; empty for methods that do not count them.
  virtual std::vector<double> gatherRays() const { return {}; }

  /// Independent replicates to run for `trajectories`, over all of them.
  virtual int replicates(long long trajectories) const { return replicateCount(trajectories); }

  /// Whether addRound() skips receivers that reached the goal (Tally::converged).
  virtual bool skipsConverged() const { return false; }

  virtual Pace pace() const { return {}; }

  /// Whether the method fills Tally::correction().
  virtual bool altersKernel() const { return false; }

  /// Which simplifications the method chose, and why.
  virtual std::vector<AuditLine> audit() const = 0;
};
}  // namespace kalos

#endif
