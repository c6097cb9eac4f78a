// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/methods/StrategyTrial.h"

#include <numeric>
#include "estimator/control/Result.h"
#include "estimator/control/Settings.h"

#include "estimator/methods/BiasCompensation.h"
#include "scene/RayCount.h"

namespace kalos
{
namespace
{
constexpr double luminousShare = 0.1;  // of the scene's area; below this a trial does not pay
constexpr std::size_t mostReceivers = 8;
constexpr int replicates = 8, trajectories = 32;  // each
constexpr double pairsPerRay = 40;                // scored in the time of a ray

bool isLuminous(const Scene& scene)
{
  double area = 0;
  for (std::uint32_t t = 0; t < scene.data().triangles.size(); ++t)
    if (photometric(scene.material(t).exitance, scene.bands()) > 0)
      area += scene.area(t);
  return area >= luminousShare * scene.surfaceArea();
}

struct Found
{
  double rays = 0;                   // per receiver; other work counts as rays of the same time
  std::vector<MeanAndError> values;  // of the receivers that were tried

  // Proportional to the time to a given error. The error is absolute: a few paths do not give each value well enough.
  double effort() const
  {
    return this->rays * std::accumulate(this->values.begin(), this->values.end(), 0.0, [](double sum, MeanAndError v) {
             return sum + v.standardError * v.standardError;
           });
  }
};

class Trial
{
public:
  Trial(const Scene& scene, const Emission& emission, const Settings& settings, const ReceiverDirectLight& direct)
      : Scene_(scene), Direct(direct), Light(scene, emission, settings, direct.shadows(), direct.sensors().size())
  {
    const std::size_t all = direct.sensors().size(), some = std::min(all, mostReceivers);
    for (std::size_t i = 0; i < some; ++i)
    {
      this->Tried.push_back((2 * i + 1) * all / (2 * some));
      this->Sensors.push_back(direct.sensors()[this->Tried.back()]);
    }
  }

  void usePathsOnly() { this->Light.usePathsOnly(); }

  Found run()
  {
    const bool paths = this->Light.gathering().pathsOnly();
    const Ranks oneProcess;
    Workers workers(1, {}, oneProcess);  // on this thread, which counts its rays
    Tally tally(this->Scene_, this->Sensors.size(), replicates);
    this->Light.prepare(this->Sensors, workers);
    const long long start = raysOfThisThread();
    const Round round = this->Light.trace(0, trajectories, replicates, workers);
    const long long traced = raysOfThisThread();
    std::size_t pairs = 0;
    const auto exactMeshes = [&](std::size_t i) { return !paths && this->Direct.exactMeshes(this->Tried[i]); };
    for (int replicate = 0; replicate < replicates; ++replicate)
      this->Light.score(this->Sensors, 0, this->Sensors.size(), replicate, round, exactMeshes, tally);
    for (std::size_t i = 0; i < this->Sensors.size() && !paths; ++i)
      for (int replicate = 0; replicate < replicates; ++replicate)
      {
        const std::size_t r = this->Tried[i];
        const Bands direct = this->Direct.fluctuation(r, pilotReplicate + 1 + replicate, 0, trajectories);
        for (int b = 0; b < tally.bands(); ++b)
          tally.total(i, replicate)[b] += direct[b];
        const LightVertices& pool = round.pools[replicate];
        pairs += pool.reflected.size() + pool.glossy.size() + (exactMeshes(i) ? 0 : pool.emitted.size());
      }
    Found found;
    found.rays = static_cast<double>(traced - start) / static_cast<double>(this->Direct.sensors().size()) +
                 (static_cast<double>(raysOfThisThread() - traced) + static_cast<double>(pairs) / pairsPerRay) /
                     static_cast<double>(this->Sensors.size());
    for (std::size_t i = 0; i < this->Sensors.size(); ++i)
      found.values.push_back(tally.summary(i, trajectories));
    return found;
  }

private:
  const Scene& Scene_;
  const ReceiverDirectLight& Direct;
  BiasCompensation Light;
  std::vector<std::size_t> Tried;  // receivers
  std::vector<Sensor> Sensors;     // of these
};
}  // namespace

bool pathsAreBetter(const Scene& scene, const Emission& emission, const Settings& settings,
                    const ReceiverDirectLight& direct)
{
  if (!settings.uses(Technique::Paths) || !settings.uses(Technique::Near) || direct.sensors().empty() ||
      !isLuminous(scene))
    return false;
  Settings own = settings;
  own.seed = mixBits(settings.seed + 0x70617468);
  Trial trial(scene, emission, own, direct);
  const double vertices = trial.run().effort();
  trial.usePathsOnly();
  return trial.run().effort() < vertices;
}

AuditLine auditPaths()
{
  return {"vertices", "none", "luminous surfaces all around: paths without vertices won a trial"};
}
}  // namespace kalos
