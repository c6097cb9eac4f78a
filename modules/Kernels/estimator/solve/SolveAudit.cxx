// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/solve/SolveAudit.h"

#include <algorithm>
#include <sstream>

#include "estimator/tally/Goal.h"
#include "scene/SceneNeeds.h"

namespace kalos
{
std::vector<AuditLine> auditMaterials(const Scene& scene)
{
  const int bands = scene.bands();
  bool glossy = false, mirror = false;
  for (const Material& m : scene.data().materials)
  {
    glossy = glossy || m.specular > 0;
    mirror = mirror || m.mirror > 0;
  }
  AuditLine reflection{"reflection", "none", "every surface is black: all light is direct"};
  if (reflects(scene))
    reflection = {
        "reflection", std::string("diffuse") + (glossy ? ", glossy" : "") + (mirror ? ", mirror" : ""),
        glossy || mirror ? "as the materials say" : "every luminance is rho E / pi, no second estimate is run"};
  return {{"bands", std::to_string(bands),
           bands == 1   ? "all materials are photometric"
           : bands == 3 ? "a material has red, green and blue"
                        : "a material has that many bands"},
          reflection};
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

AuditLine auditRanks(int processes, int replicates)
{
  return {"ranks", std::to_string(processes) + " processes",
          std::to_string(replicates) + " replicates are shared out, scene and receivers replicated"};
}

AuditLine auditStop(const Result& result)
{
  return {"stopped", "after " + std::to_string(result.trajectories) + " trajectories",
          "from outside, before the goal; the unfinished round is discarded"};
}
}  // namespace kalos
