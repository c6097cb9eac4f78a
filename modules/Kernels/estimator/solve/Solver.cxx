// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Solver.h"

#include <ctime>

#include "estimator/solve/AdaptiveSampling.h"
#include "estimator/solve/Checkpoint.h"
#include "estimator/solve/OverlapAudit.h"
#include "estimator/solve/RunningSolve.h"
#include "estimator/solve/SolveAudit.h"
#include "estimator/tally/CheckFinite.h"
#include "estimator/tally/IntervalDiagnostics.h"
#include "scene/RayCount.h"

namespace kalos
{
namespace
{
constexpr double farFromGoal = 1.5;  // half-widths over the goal, above which a pilot pays

// Time, processor time and rays since it was made.
class Meter
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  double cpuSeconds() const { return static_cast<double>(std::clock() - this->CpuStart) / CLOCKS_PER_SEC; }
  long long rays() const { return raysTraced() - this->RaysBefore; }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::clock_t CpuStart = std::clock();
  long long RaysBefore = raysTraced();
};

class Solve
{
public:
  Solve(const Scene& scene, const Receivers& receivers, const Settings& settings, const Progress& progress,
        const Snapshot& snapshot)
      : Run(scene, receivers, settings, progress, static_cast<bool>(snapshot)),
        Show(snapshot),
        Saved(settings.checkpoint, this->Run.ranks)
  {
    this->Found.alteredKernel = this->Run.estimator->altersKernel();
  }

  Result run();

private:
  void begin();
  bool planEffort();
  int nextRound();
  void addRound(int count);
  void show();
  void finish();
  void measure();
  void conclude();

  RunningSolve Run;
  const Snapshot& Show;
  const Meter Measured;
  Result Found;
  double Showing = 0;     // s spent in snapshots
  Done Before;            // of the resumed solve
  long long Planned = 0;  // as Done::planned
  Checkpoint Saved;
  std::unique_ptr<AdaptiveSampling> Plan;
  bool Running = true;
};

Result Solve::run()
{
  this->begin();
  while (this->Running)
  {
    this->measure();
    if (!this->planEffort())
      break;
    const int count = this->nextRound();
    if (count <= 0)
      break;
    this->addRound(count);
    this->show();
  }
  this->finish();
  return std::move(this->Found);
}

// The work before the first round, and the state of an interrupted solve.
void Solve::begin()
{
  RunningSolve& run = this->Run;
  this->Running = run.prepare();
  if (this->Running && run.settings.checkpoint)
    this->Saved.resume(identify(run.scene, run.receivers, run.settings, static_cast<bool>(this->Show)), this->Before,
                       run.tally, *run.estimator);
  run.done = this->Before.trajectories;
  this->Planned = this->Before.planned;
  if (run.done > 0)
    this->conclude();
}

// Decides once whether converged receivers are skipped, and marks them. False when aborted.
bool Solve::planEffort()
{
  RunningSolve& run = this->Run;
  if (this->Planned == 0 && run.done >= AdaptiveSampling::pilotTrajectories)
  {
    const bool wanted =
        run.settings.relativeError > 0 && run.settings.uses(Technique::Effort) && run.estimator->skipsConverged();
    this->Planned = wanted && run.schedule.goal().distance(run.tally, run.done) > farFromGoal ? 2 : 1;
  }
  if (this->Planned == 2 && !this->Plan)
    this->Plan = kalos::planEffort(run.scene, run.receivers, run.settings, run.schedule.goal(), run.tally.replicates(),
                                   run.ranks, run.workers);
  this->Running = this->Planned != 2 || this->Plan;
  if (this->Plan)
    run.tally.setConverged(this->Plan->converged(run.schedule.goal(), run.tally, run.done));
  return this->Running;
}

// Trajectories of every replicate in the next round; 0 when the work is done.
int Solve::nextRound()
{
  RunningSolve& run = this->Run;
  const int count = run.schedule.next(run.done, run.ranks.agree(this->Found.seconds), run.tally);
  if (count > 0)
    run.workers.setSpan(run.schedule.fraction(), run.schedule.fractionAfter(run.done, count));
  return count;
}

void Solve::addRound(int count)
{
  RunningSolve& run = this->Run;
  this->Running = run.addRound(count);
  if (!this->Running)
    return;
  checkFinite(run.tally, run.scene, run.receivers, run.settings, run.done - count, count);
  this->conclude();
  this->measure();
  this->Saved.keep({run.done, this->Found.seconds, this->Found.cpuSeconds, this->Found.rays, this->Planned}, run.tally,
                   *run.estimator);
}

void Solve::show()
{
  if (!this->Running || !this->Show)
    return;
  this->measure();
  const Meter shown;
  this->Show(this->Found);
  this->Showing += shown.seconds();
}

void Solve::measure()
{
  this->Found.seconds =
      this->Before.seconds + this->Measured.seconds() - this->Run.workers.secondsTelling() - this->Showing;
  this->Found.cpuSeconds = this->Before.cpuSeconds + this->Measured.cpuSeconds();
  this->Found.rays = this->Before.rays + this->Measured.rays();
}

// Fills the result from the complete trajectories.
void Solve::conclude()
{
  const RunningSolve& run = this->Run;
  const Tally& tally = run.tally;
  Result& result = this->Found;
  tally.write(run.done, result);
  result.trajectories = run.done * tally.replicates();
  result.replicateIlluminance.clear();
  for (std::size_t r = 0; run.settings.keepReplicates && r < tally.receivers(); ++r)
  {
    const std::vector<double> estimates = tally.estimates(r, run.done);
    result.replicateIlluminance.insert(result.replicateIlluminance.end(), estimates.begin(), estimates.end());
  }
  result.gatherRays = run.estimator->gatherRays();
  result.trusted.clear();
  for (std::size_t r = 0; r < tally.receivers(); ++r)
    result.trusted.push_back(tailIsLight(result.largestScoreShare[r], tally.largestStandsOut(r),
                                         {result.illuminance[r], result.standardError[r]}) &&
                             hiddenIsLittle(tally.picks(r), static_cast<double>(result.trajectories),
                                            {result.illuminance[r], result.standardError[r]}) &&
                             run.estimator->trusts(r, tally.trajectories(r, run.done) * tally.replicates()));
  run.schedule.goal().judge(result);
}

void Solve::finish()
{
  const RunningSolve& run = this->Run;
  Result& result = this->Found;
  this->Saved.save();
  result.aborted = !this->Running;
  this->measure();
  result.cpuSeconds = run.ranks.sum(result.cpuSeconds);
  result.rays = static_cast<decltype(result.rays)>(run.ranks.sum(static_cast<double>(result.rays)));
  result.audit = auditMaterials(run.scene);
  for (const std::vector<AuditLine>& lines :
       {run.estimator->audit(), run.tally.auditEnergy(), auditOverlaps(run.scene)})
    result.audit.insert(result.audit.end(), lines.begin(), lines.end());
  if (!result.goal.empty())
    result.audit.push_back(auditGoal(run.settings, result));
  if (this->Plan)
    result.audit.push_back(auditEffort(run.tally, run.done));
  if (run.ranks.size() > 1)
    result.audit.push_back(auditRanks(run.ranks.size(), run.tally.replicates()));
  if (result.aborted)
    result.audit.push_back(auditStop(result));
}
}  // namespace

Result solve(const Scene& scene, const Receivers& receivers, const Settings& settings, const Progress& progress,
             const Snapshot& snapshot)
{
  return Solve(scene, receivers, settings, progress, snapshot).run();
}
}  // namespace kalos
