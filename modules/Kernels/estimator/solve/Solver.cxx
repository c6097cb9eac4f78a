// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/Solver.h"

#include <ctime>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "estimator/kernel/KernelRegularization.h"
#include "estimator/methods/EstimatorFactory.h"
#include "estimator/solve/AdaptiveSampling.h"
#include "estimator/solve/Checkpoint.h"
#include "estimator/tally/CheckFinite.h"
#include "estimator/tally/Goal.h"
#include "estimator/tally/IntervalDiagnostics.h"
#include "scene/RayCount.h"

namespace kalos
{
namespace
{
constexpr long long unlimited = std::numeric_limits<long long>::max() / 64;
constexpr int largestRound = 8192;       // trajectories per replicate: bounds the memory of the vertices
constexpr int firstRound = 64;           // with a goal: enough for a first standard error
constexpr double farFromGoal = 1.5;      // half-widths over the goal, above which a pilot pays
constexpr double largestWork = 1 << 25;  // scores of trajectories: a stop loses the round that it interrupts

void check(const Receivers& receivers, const Settings& s)
{
  auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw std::invalid_argument(message);
  };
  require(s.trajectories >= 0, "trajectories: must be 0 (automatic) or more");
  require(s.relativeError >= 0 && s.relativeError < 1, "error: must lie in [0, 1)");
  require(std::isfinite(s.errorFloor), "error_floor: must be a half-width in lux, or negative (automatic)");
  require(s.seconds >= 0 && std::isfinite(s.seconds), "time: must be 0 (no limit) or more seconds");
  require(s.threads >= 0, "threads: must be 0 (all) or more");
  require(receivers.points.size() == receivers.normals.size(), "receivers: one normal per point is expected");
  for (std::size_t i = 0; i < receivers.points.size(); ++i)
  {
    require(isFinite(receivers.points[i]), "receiver " + std::to_string(i) + ": coordinates must be finite");
    require(std::abs(length(receivers.normals[i]) - 1) < 1e-3,
            "receiver " + std::to_string(i) + ": its normal must be a unit vector");
  }
}

// Decides how many trajectories per replicate come next; 0 when the work is done.
class Schedule
{
public:
  Schedule(const Settings& settings, const Tally& tally, const Pace& pace, long long limit, bool shown)
      : Settings_(settings),
        Shown(shown),
        Limit((limit + tally.replicates() - 1) / tally.replicates()),
        Paced(pace),
        Wished(settings, tally.replicates())
  {
  }

  bool hasGoal() const { return this->Settings_.relativeError > 0 || this->Settings_.seconds > 0; }

  int next(long long done, double seconds, const Tally& tally)
  {
    long long target = this->Limit;
    this->Fraction = static_cast<double>(done) / static_cast<double>(this->Limit);
    if (this->hasGoal())
      target = std::max<long long>(firstRound, (tally.active() < tally.receivers() ? 2 : 4) * done);
    if (this->hasGoal() && done > 0)
    {
      if (this->Settings_.relativeError > 0 && done >= firstRound)
      {
        // The variance falls as 1/n: aim a little beyond the goal, so that one more round mostly suffices.
        const double ratio = this->Wished.distance(tally, done);
        if (ratio <= 1)
          return 0;
        this->Fraction = std::max(this->Fraction, 1 / (ratio * ratio));
        const double aim = 1.1 * ratio * ratio * static_cast<double>(done);
        target = std::min(target, static_cast<long long>(std::min(aim, static_cast<double>(unlimited))) + 1);
      }
      if (this->Settings_.seconds > 0)
      {
        const double left = this->Settings_.seconds - seconds, each = seconds / static_cast<double>(done);
        this->Fraction = std::max(this->Fraction, seconds / this->Settings_.seconds);
        if (left < each)
          return 0;
        target = std::min(target, done + static_cast<long long>(0.9 * left / each) + 1);
      }
    }
    if (this->Shown)
      target = std::min(target, done + std::max(1LL, done / 2));
    const int multiple = this->Paced.multiple;
    const long long wished = (target - done + multiple - 1) / multiple * multiple;
    const long long count = std::min<long long>(this->largest(tally), wished), left = this->Limit - done;
    return static_cast<int>(left < count + multiple ? left : count);
  }

  double fraction() const { return std::min(1.0, this->Fraction); }
  const Goal& goal() const { return this->Wished; }

private:
  // A power of two, because a Sobol' sequence is evenly stratified over that many points.
  int largest(const Tally& tally) const
  {
    const double scores = static_cast<double>(tally.active()) * tally.replicates() * this->Paced.work;
    int count = this->Paced.smallest;
    while (2 * count <= largestRound && 2 * count * scores <= largestWork)
      count *= 2;
    return count;
  }

  Settings Settings_;
  bool Shown;
  long long Limit;
  Pace Paced;
  Goal Wished;
  double Fraction = 0;
};

// Fills the result from `done` complete trajectories of every replicate.
void conclude(const Tally& tally, long long done, const Estimator& estimator, const Goal& goal, bool keepReplicates,
              Result& result)
{
  tally.write(done, result);
  result.trajectories = done * tally.replicates();
  result.replicateIlluminance.clear();
  for (std::size_t r = 0; keepReplicates && r < tally.receivers(); ++r)
  {
    const std::vector<double> estimates = tally.estimates(r, done);
    result.replicateIlluminance.insert(result.replicateIlluminance.end(), estimates.begin(), estimates.end());
  }
  result.gatherRays = estimator.gatherRays();
  result.trusted.clear();
  for (std::size_t r = 0; r < tally.receivers(); ++r)
    result.trusted.push_back(tailIsLight(result.largestScoreShare[r], tally.largestStandsOut(r),
                                         {result.illuminance[r], result.standardError[r]}) &&
                             estimator.trusts(r, tally.trajectories(r, done) * tally.replicates()));
  goal.judge(result);
}

AuditLine auditGoal(const Settings& settings, const Result& result)
{
  const auto count = [&](GoalStatus status) {
    return std::count(result.goal.begin(), result.goal.end(), static_cast<char>(status));
  };
  const auto missed = count(GoalStatus::Missed);
  std::ostringstream choice;
  choice << 100 * settings.relativeError << " % at " << count(GoalStatus::WithinError) << ", below "
         << result.errorFloor << " lx at " << count(GoalStatus::BelowFloor) << ", missed at " << missed << " of "
         << result.goal.size() << " receivers";
  const bool usedUp = settings.trajectories > 0 && result.trajectories >= settings.trajectories;
  return {"error", choice.str(),
          missed == 0      ? "95 % half-widths, relative to the values or absolute"
          : result.aborted ? "stopped from outside before"
          : usedUp         ? "all trajectories allowed were used before"
                           : "the time was up before"};
}

bool plansEffort(const Settings& settings, const Estimator& estimator)
{
  return settings.relativeError > 0 && !settings.evenEffort && estimator.skipsConverged();
}

double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}  // namespace

Result solve(const Scene& scene, const Receivers& receivers, const Settings& settings, const Progress& progress,
             const Snapshot& snapshot)
{
  check(receivers, settings);
  neighbourhood(scene, settings, 0);  // rejects invalid delta and epsilon for every method
  const bool goal = settings.relativeError > 0 || settings.seconds > 0;
  const long long limit = settings.trajectories ? settings.trajectories : goal ? unlimited : defaultTrajectories;
  const Ranks oneProcess;
  const Ranks& ranks = settings.ranks ? *settings.ranks : oneProcess;
  std::unique_ptr<Estimator> estimator;
  ranks.together([&] { return (estimator = makeEstimator(scene, receivers, settings)) != nullptr; });
  const int replicates = estimator->replicates(goal ? 32 : limit);
  Workers workers(settings.threads, progress, ranks);
  Tally tally(scene, receivers.points.size(), replicates);
  Schedule schedule(settings, tally, estimator->pace(), limit, static_cast<bool>(snapshot));
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpuStart = std::clock();
  const long long raysBefore = raysTraced();

  Result result;
  result.alteredKernel = estimator->altersKernel();
  double showing = 0;  // s spent in snapshots
  Done before;         // of the resumed solve
  auto clock = [&] {
    result.seconds = before.seconds + secondsSince(start) - workers.secondsTelling() - showing;
    result.cpuSeconds = before.cpuSeconds + static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
    result.rays = before.rays + raysTraced() - raysBefore;
  };
  Checkpoint checkpoint(settings.checkpoint, ranks);
  bool running = ranks.together([&] { return estimator->prepare(workers, tally); });
  if (running && settings.checkpoint)
    checkpoint.resume(identify(scene, receivers, settings, static_cast<bool>(snapshot)), before, tally, *estimator);
  std::unique_ptr<AdaptiveSampling> plan;
  long long done = before.trajectories, planned = before.planned;
  if (done > 0)
    conclude(tally, done, *estimator, schedule.goal(), settings.keepReplicates, result);
  while (running)
  {
    clock();
    if (planned == 0 && done >= AdaptiveSampling::pilotTrajectories)
      planned = plansEffort(settings, *estimator) && schedule.goal().distance(tally, done) > farFromGoal ? 2 : 1;
    if (planned == 2 && !plan)
      plan = planEffort(scene, receivers, settings, schedule.goal(), replicates, ranks, workers);
    running = planned != 2 || plan;
    if (!running)
      break;
    if (plan)
      tally.setConverged(plan->converged(schedule.goal(), tally, done));
    const int count = schedule.next(done, ranks.agree(result.seconds), tally);
    if (count <= 0)
      break;
    workers.setSpan(schedule.fraction(),
                    schedule.hasGoal() ? schedule.fraction()
                                       : static_cast<double>(done + count) * replicates / static_cast<double>(limit));
    running = ranks.together([&] { return estimator->addRound(done, count, workers, tally); });
    if (running)
    {
      tally.exchange(ranks);
      if (done > 0)
        tally.keepConverged(done, count);
      estimator->exchange(ranks);
      checkFinite(tally, scene, receivers, settings, done, count);
      conclude(tally, done += count, *estimator, schedule.goal(), settings.keepReplicates, result);
      clock();
      checkpoint.keep({done, result.seconds, result.cpuSeconds, result.rays, planned}, tally, *estimator);
    }
    if (running && snapshot)
    {
      clock();
      const auto shown = std::chrono::steady_clock::now();
      snapshot(result);
      showing += secondsSince(shown);
    }
  }
  checkpoint.save();
  result.aborted = !running;
  clock();
  result.cpuSeconds = ranks.sum(result.cpuSeconds);
  result.rays = static_cast<decltype(result.rays)>(ranks.sum(static_cast<double>(result.rays)));
  result.audit = estimator->audit();
  for (AuditLine& line : tally.auditEnergy())
    result.audit.push_back(std::move(line));
  if (!result.goal.empty())
    result.audit.push_back(auditGoal(settings, result));
  if (plan)
    result.audit.push_back(auditEffort(tally, done));
  if (ranks.size() > 1)
    result.audit.push_back({"ranks", std::to_string(ranks.size()) + " processes",
                            std::to_string(replicates) + " replicates are shared out, scene and receivers replicated"});
  if (result.aborted)
    result.audit.push_back({"stopped", "after " + std::to_string(result.trajectories) + " trajectories",
                            "from outside, before the goal; the unfinished round is discarded"});
  return result;
}

Replay replay(const Scene& scene, const Receivers& receivers, const Settings& settings, std::size_t receiver,
              int replicate)
{
  check(receivers, settings);
  neighbourhood(scene, settings, 0);
  auto require = [](bool condition, const std::string& message) {
    if (!condition)
      throw std::invalid_argument("replay: " + message);
  };
  require(settings.relativeError == 0 && settings.seconds == 0,
          "the solve has a goal, so that its rounds depend on all receivers; expected only trajectories");
  const long long limit = settings.trajectories ? settings.trajectories : defaultTrajectories;
  const std::unique_ptr<Estimator> estimator = makeEstimator(scene, receivers, settings);
  Replay found;
  found.replicates = estimator->replicates(limit);
  require(receiver < receivers.points.size(), "receiver " + std::to_string(receiver) + " is not there; expected 0 to " +
                                                  std::to_string(receivers.points.size() - 1));
  require(replicate >= 0 && replicate < found.replicates, "replicate " + std::to_string(replicate) +
                                                              " is not there; expected 0 to " +
                                                              std::to_string(found.replicates - 1));
  const Ranks oneProcess;
  Workers workers(settings.threads, {}, oneProcess);
  Tally tally(scene, receivers.points.size(), found.replicates);
  Schedule schedule(settings, tally, estimator->pace(), limit, false);
  estimator->prepare(workers, tally);
  workers.only(replicate);
  found.fixed = photometric(tally.fixed(receiver), scene.bands());
  RoundScores before;
  while (const int count = schedule.next(found.trajectories, 0, tally))
  {
    estimator->addRound(found.trajectories, count, workers, tally);
    const double sum = photometric(tally.total(receiver, replicate), scene.bands());
    const double direct = photometric(tally.direct(receiver, replicate), scene.bands());
    found.rounds.push_back(
        {found.trajectories, count, sum - before.sum, direct - before.direct, tally.largest(receiver, replicate)});
    before.sum = sum;
    before.direct = direct;
    found.trajectories += count;
  }
  found.estimate = found.fixed + before.sum / static_cast<double>(found.trajectories);
  return found;
}
}  // namespace kalos
