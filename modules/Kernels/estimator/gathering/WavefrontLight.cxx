// SPDX-License-Identifier: BSD-3-Clause
// The light that reaches the ends of gather rays; see estimator/gathering/WavefrontGather.h.
#include <cmath>

#include "estimator/gathering/WavefrontGather.h"
#include "estimator/kernel/VertexResampling.h"

namespace kalos
{
void WavefrontGather::addLuminaires(std::size_t i)
{
  PathState& path = this->Paths[i];
  DirectLight::Sample sample;
  Bands known{};
  if (path.lobeOnly && path.at.keptLobe == 0)
    return;
  if (this->Rays.luminaires().sampleUnshadowed(path.at, path.random, sample, known))
    this->addIfSeen(i, sample.target, sample.light);
  if (path.at.brdf)
    this->addWeighted(i, known);
}

void WavefrontGather::addHighlights(std::size_t i, double probability)
{
  PathState& path = this->Paths[i];
  if (!path.at.highlightsApart || path.lobeOnly || (probability < 1 && path.random.next() >= probability))
    return;
  Bands light = this->Rays.highlights().sample(path.at, path.random);
  for (std::size_t b = 0; b < this->Count; ++b)
    light[b] /= probability;
  this->addWeighted(i, light);
}

void WavefrontGather::addVertices(std::size_t i, int blockSize)
{
  const LightVertices& pool = *this->Pool.vertices;
  const int trajectories = this->Pool.trajectories;
  if (!this->Rays.pathsOnly())
    for (const VertexSet* set : {&pool.reflected, &pool.glossy})
      this->addBlock(i, *set, set->isGlossy() ? blockSize / glossyCost : blockSize,
                     this->Rays.blockShare(trajectories, blockSize));
  if (this->Rays.usesStarts())
    this->addBlock(i, pool.emitted, blockSize, this->Rays.startShare(trajectories, blockSize));
}

void WavefrontGather::addBlock(std::size_t i, const VertexSet& set, int blockSize, double share)
{
  if (set.size() == 0)
    return;
  static_assert(rayBlock <= VertexTile::capacity && cellBlock <= VertexTile::capacity, "a block is scored as one tile");
  // A run of vertices from a random start, wrapped at the end, so that each vertex has the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(this->Paths[i].random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size) / this->Pool.trajectories;
  this->addRun(i, set, begin, straight, share, weight);
  if (straight < size)
    this->addRun(i, set, 0, size - straight, share, weight);
}

void WavefrontGather::addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share,
                             double weight)
{
  PathState& path = this->Paths[i];
  const double u = path.random.next();
  ResampledScore pick;
  const bool picks = this->Rays.picksVertices();
  if (!picks)
  {
    // Every pair has a shadow ray of its own, or none can be hidden.
    pick.light = {};
    const ShadowPicks all{this->Rays.shadows() ? &this->Rays.scene().rays() : nullptr, 0, u};
    addResampledScores(set, begin, static_cast<int>(count), path.at, share, all, pick.light.data());
  }
  else if (!resampleOne(set, begin, static_cast<int>(count), path.at, share, u, pick))
    return;
  for (std::size_t b = 0; b < this->Count; ++b)
    pick.light[b] *= weight;
  if (picks)
    this->addIfSeen(i, pick.target, pick.light);
  else
    this->addWeighted(i, pick.light);
}

void WavefrontGather::addWeighted(std::size_t i, const Bands& light)
{
  for (std::size_t b = 0; b < this->Count; ++b)
    this->found(i)[b] += this->Paths[i].throughput[b] * light[b];
}

void WavefrontGather::addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light)
{
  const PathState& path = this->Paths[i];
  // A NaN skips the shadow test, so that checkFinite() reports it.
  if (!this->Rays.shadows() || std::isnan(light[0]))
    return this->addWeighted(i, light);
  this->Shadows.push_back({path.at.anchor, target, path.doublePrecision});
  this->PendingPath.push_back(i);
  for (std::size_t b = 0; b < this->Count; ++b)
    this->PendingContributions.push_back(path.throughput[b] * light[b]);
}

void WavefrontGather::addSeen()
{
  shadowTogether(this->Rays.scene().rays(), this->Shadows);
  for (std::size_t k = 0; k < this->Shadows.size(); ++k)
    for (std::size_t b = 0; b < this->Count && !this->Shadows[k].hidden; ++b)
      this->found(this->PendingPath[k])[b] += this->PendingContributions[k * this->Count + b];
  this->Shadows.clear();
  this->PendingContributions.clear();
  this->PendingPath.clear();
}
}  // namespace kalos
