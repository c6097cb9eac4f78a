// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: the state of a solve, so that an interrupted solve can resume. All random numbers are keyed by their
// use, so a checkpoint holds only sums and counters. A resumed solve gives bitwise the same numbers as an uninterrupted
// one.
//
// Form: the word KALOSCP2; the length and the text of the identity, lines `name<TAB>value`; the length and the bytes of
// the state; the fingerprint of all that. Lengths and fingerprint are 64-bit words in the machine's byte order.
#ifndef kalos_estimator_solve_Checkpoint_h
#define kalos_estimator_solve_Checkpoint_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"
#include "estimator/methods/Estimator.h"

namespace kalos
{
/// The version of Kalos, as outputs and checkpoints name it.
const char* version();

/// Where a checkpoint is kept. A higher layer handles files; the kernels know only bytes.
class CheckpointStore
{
public:
  virtual ~CheckpointStore() = default;

  /// What was saved last; empty when there is none. Throws std::invalid_argument when nothing can be saved there.
  virtual std::string load() = 0;

  /// Replaces the last save atomically. Reports a failure by other means and does not throw.
  virtual void save(const std::string& bytes) = 0;

  virtual std::string name() const = 0;           ///< for messages
  virtual double interval() const { return 10; }  ///< s between saves; a solve also saves at its end
};

/// What must match to resume a solve: names with values, without threads and ranks, which change no number.
using Identity = std::vector<std::pair<std::string, std::string>>;
Identity identify(const Scene& scene, const Receivers& receivers, const Settings& settings, bool shown);

/// A checkpoint, and the state in one. unseal() throws std::invalid_argument with the reason when the bytes are damaged
/// or of another identity.
std::string seal(const Identity& identity, const std::string& state);
std::string unseal(const std::string& bytes, const Identity& expected);

/// Progress of a solve.
struct Done
{
  long long trajectories = 0;  ///< per replicate
  double seconds = 0, cpuSeconds = 0;
  long long rays = 0;
  long long planned =
      0;  ///< whether effort is planned (estimator/solve/AdaptiveSampling.h): 0 not decided yet, 1 no, 2 yes
};

/// The checkpoint of one solve; without a store every call does nothing.
class Checkpoint
{
public:
  Checkpoint(CheckpointStore* store, const Ranks& ranks) : Store(store), Sharing(ranks) {}

  /// Restores the saved state, after Estimator::prepare(); every rank must call. Throws std::invalid_argument for a
  /// checkpoint that is from another solve.
  void resume(const Identity& identity, Done& done, Tally& tally, Estimator& estimator);

  /// A round is complete: records the state, and saves it when the interval has passed. Every rank must call.
  void keep(Done done, Tally& tally, Estimator& estimator);

  /// Saves the last recorded state.
  void save();

private:
  CheckpointStore* Store;
  const Ranks& Sharing;
  Identity Own;
  std::string Noted;  // not yet saved
  std::chrono::steady_clock::time_point Saved = std::chrono::steady_clock::now();
};
}  // namespace kalos

#endif
