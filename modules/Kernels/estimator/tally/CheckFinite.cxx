// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tally/CheckFinite.h"

#include <sstream>
#include <stdexcept>
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

#include "estimator/tracing/EmissionPilot.h"
#include "estimator/tracing/Trajectories.h"

namespace kalos
{
namespace
{
std::string place(const Vec3& p)
{
  std::ostringstream text;
  text << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return text.str();
}

// Describes the first vertex of a set with an invalid flux, position or normal; empty when all are valid.
std::string faultIn(const VertexSet& set, const Vec3& origin)
{
  for (std::size_t i = 0; i < set.size(); ++i)
    for (const std::vector<float>& flux : set.flux)
      if (!(flux[i] >= 0 && std::isfinite(flux[i])) || !isFinite(set.position(i)) || !isFinite(set.normal(i)))
        return "vertex " + std::to_string(i) + " at " + place(set.position(i) + origin) + " carries " +
               std::to_string(flux[i]) + " lm";
  return {};
}

std::string culprit(const Scene& scene, const Receivers& receivers, const Settings& settings, int replicate,
                    long long first, int count)
{
  const Emission emission = makeEmission(scene, receivers, settings);
  for (long long i = first; emission.totalFlux() > 0 && i < first + count; ++i)
  {
    const LightVertices pool = traceTrajectories(scene, emission, settings.walks(), replicate, i, 1);
    for (const VertexSet* set : {&pool.reflected, &pool.glossy, &pool.emitted})
    {
      const std::string fault = faultIn(*set, scene.origin());
      if (!fault.empty())
        return "trajectory " + std::to_string(i) + ", " + fault;
    }
  }
  return "trajectories " + std::to_string(first) + " to " + std::to_string(first + count - 1) +
         ", no vertex of them: direct light or a gather ray";
}
}  // namespace

void checkFinite(const Tally& tally, const Scene& scene, const Receivers& receivers, const Settings& settings,
                 long long first, int count)
{
  for (std::size_t r = 0; r < tally.receivers(); ++r)
    for (int p = 0; p < tally.replicates(); ++p)
      if (!tally.sound(r, p))
        throw std::runtime_error(
            "receiver " + std::to_string(r) + " at " + place(receivers.points[r]) + ": a score of replicate " +
            std::to_string(p) +
            " is infinite, negative or not a number: " + culprit(scene, receivers, settings, p, first, count));
}
}  // namespace kalos
