// SPDX-License-Identifier: BSD-3-Clause
// The result of a solve.
#ifndef kalos_estimator_control_Result_h
#define kalos_estimator_control_Result_h

#include <functional>
#include <string>
#include <vector>

namespace kalos
{
struct AuditLine
{
  std::string subject, choice, reason;
};

struct Result
{
  int bands = 1;
  std::vector<double> illuminance;           ///< lx, photometric
  std::vector<double> standardError;         ///< lx, of the photometric illuminance
  std::vector<double> direct;                ///< lx, photometric, straight from the emitters
  std::vector<double> indirectError;         ///< lx, standard error of illuminance less direct
  std::vector<double> replicateIlluminance;  ///< lx, `replicates` estimates per receiver; see Settings::keepReplicates
  std::vector<double> illuminanceBands;      ///< lx, bands() values per receiver
  std::vector<double> kernelCorrection;      ///< lx, altered kernel less plain kernel on the same trajectories
  std::vector<double> largestScoreShare;     ///< largest single score over the sum of all, [0, 1]
  std::vector<char>
      trusted;  ///< 1 where the standard error can be believed; rule in estimator/tally/IntervalDiagnostics.h
  std::vector<double> gatherRays;  ///< sent from each receiver by `compensated`; empty for other methods
  std::vector<char> goal;          ///< a GoalStatus each (estimator/tally/Goal.h); empty without a goal for the error
  double errorFloor = 0;           ///< lx, by which that was judged
  long long trajectories = 0;
  long long rays = 0;  ///< traced by the solve; includes those of concurrent solves of the process
  int replicates = 0;
  bool aborted = false;
  double skyIlluminance = 0;   ///< lx, of the sky without the sun on the horizontal; 0 without a sky
  bool alteredKernel = false;  ///< the method alters the kernel and fills kernelCorrection
  double seconds = 0, cpuSeconds = 0;
  std::vector<AuditLine> audit;
};

/// Called now and then on the thread that called solve(), with a fraction in [0,1]; returns false to abort.
/// The solve waits for it: a callback that waits pauses the solve.
using Progress = std::function<bool(double)>;

/// Called after each round, on the thread that called solve(), with the result so far.
using Snapshot = std::function<void(const Result&)>;
}  // namespace kalos

#endif
