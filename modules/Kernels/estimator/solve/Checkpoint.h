// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: what a solve has done so far, so that one that was ended goes on where it was. All random numbers are
// keyed by what they are for, so sums and counters are all there is to keep, and the resumed run gives bitwise the
// numbers of one that was never ended.
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

/// Where a checkpoint is kept. Files come in from above: the kernels know only bytes.
class CheckpointStore
{
public:
  virtual ~CheckpointStore() = default;

  /// What was saved last; empty when there is none. Throws std::invalid_argument when nothing can be saved there.
  virtual std::string load() = 0;

  /// Replaces what was saved before, at once or not at all. A failure is told by other means and ends nothing.
  virtual void save(const std::string& bytes) = 0;

  virtual std::string name() const = 0;           ///< for messages
  virtual double interval() const { return 10; }  ///< s between saves, but for those at the end of a solve
};

/// What must be the same for a solve to go on: names with values, all but threads and ranks, which change no number.
using Identity = std::vector<std::pair<std::string, std::string>>;
Identity identify(const Scene& scene, const Receivers& receivers, const Settings& settings, bool shown);

/// A checkpoint, and the state in one. unseal() throws std::invalid_argument with the reason when the bytes are damaged
/// or of another identity.
std::string seal(const Identity& identity, const std::string& state);
std::string unseal(const std::string& bytes, const Identity& expected);

/// What a solve has done.
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

  /// Puts back what was saved, after Estimator::prepare(); every rank must call. Throws std::invalid_argument for a
  /// checkpoint that is not of this solve.
  void resume(const Identity& identity, Done& done, Tally& tally, Estimator& estimator);

  /// A round is complete: notes the state, and saves it when the interval is over. Every rank must call.
  void keep(Done done, Tally& tally, Estimator& estimator);

  /// Saves the state noted last.
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
