// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/GatherContext.h"

#include "estimator/tracing/VertexRound.h"

namespace kalos
{
namespace
{
constexpr int keptForBalance = 16;  // without vertices, one of so many trajectories is traced
}  // namespace

GatherContext::GatherContext(const Scene& scene, const Emission& emission, const Settings& settings, bool shadows)
    : Scene_(scene),
      Source(emission),
      Density(scene, emission, settings.walks()),
      Shadows(shadows),
      EveryPair(!settings.uses(Technique::Picked)),
      Luminaires(scene, false, shadows),
      Mirrored(scene)
{
}

std::vector<LightVertices> GatherContext::trace(const Emission& emission, const Walks& walks, int replicates,
                                                long long first, int count, Workers& workers) const
{
  if (this->PathsOnly)
  {
    const long long begin = (first + keptForBalance - 1) / keptForBalance;
    const long long end = (first + count + keptForBalance - 1) / keptForBalance;
    return traceRound(this->Scene_, emission, walks, replicates, begin, static_cast<int>(end - begin), workers);
  }
  std::vector<LightVertices> pools = traceRound(this->Scene_, emission, walks, replicates, first, count, workers);
  if (!workers.forEach(pools.size(), [&](std::size_t p) { this->Density.annotate(pools[p]); }))
    pools.clear();
  return pools;
}

double GatherContext::blockShare(int trajectories, int blockSize) const
{
  if (this->PathsOnly)
    return std::numeric_limits<double>::infinity();
  // One gather ray against the trajectories that a block stands for.
  const double vertices = std::max(this->Density.collisions(), this->Density.starts()) * trajectories;
  return 1 / (trajectories * std::min(1.0, blockSize / vertices));
}

double GatherContext::startShare(int trajectories, int blockSize) const
{
  if (!this->PathsOnly)
    return this->blockShare(trajectories, blockSize);
  if (!this->Starts || !(this->Density.starts() > 0))
    return std::numeric_limits<double>::infinity();
  return 1 / (trajectories * std::min(1.0, blockSize / (this->Density.starts() * trajectories)));
}

double GatherContext::luminaireShare(const Sensor& at, std::size_t luminaire, double ratio) const
{
  if (std::isinf(ratio))
    return 1;
  const double more = this->firstHitDensity(at, luminaire) / this->vertexDensity(at);
  return more > 1 ? gatheredShare(ratio / more) / gatheredShare(ratio) : 1;
}

Bands GatherContext::luminaireLight(const Sensor& sensor, SampleStream& random) const
{
  Bands light = this->Luminaires.sample(sensor, random);
  const Bands images = this->Mirrored.any() ? this->Mirrored.illuminance(sensor) : Bands{};
  for (int b = 0; b < this->Scene_.bands(); ++b)
    light[b] += images[b];
  return light;
}

void GatherContext::luminaireLight(const Sensor* sensors, int count, bool afar, SampleStream& random,
                                   DirectLight::Sample* samples) const
{
  if (afar)
    return this->Luminaires.sample(sensors, count, random, samples);
  for (int i = 0; i < count; ++i)
  {
    Bands unused{};
    samples[i].luminaire = 0;
    if (!this->Luminaires.sampleUnshadowed(sensors[i], random, samples[i], unused) ||
        (this->Shadows && this->Scene_.rays().occluded(sensors[i].anchor, samples[i].target)))
      samples[i].light = {};
  }
}
}  // namespace kalos
