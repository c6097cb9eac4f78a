// SPDX-License-Identifier: BSD-3-Clause
// The light at the ends of a wave's gather rays.
#include <cmath>

#include "estimator/gathering/WavefrontGather.h"
#include "estimator/kernel/VertexResampling.h"

namespace kalos
{
void WavefrontGather::addLuminaires(std::size_t i, double ratio)
{
  PathState& path = this->Paths[i];
  DirectLight::Sample sample;
  Bands known{};
  if (this->Rays.luminaires().sampleUnshadowed(path.at, path.random, sample, known))
  {
    const double share = path.at.brdf ? 1 : this->Rays.luminaireShare(path.at, sample.luminaire, ratio);
    for (std::size_t b = 0; b < this->Count; ++b)
      sample.light[b] *= share;
    this->addIfSeen(i, sample.target, sample.light);
  }
  if (path.at.brdf)
    this->addWeighted(i, known);
}

void WavefrontGather::addHighlights(std::size_t i, double probability)
{
  PathState& path = this->Paths[i];
  if (!path.at.highlightsApart || (probability < 1 && path.random.next() >= probability))
    return;
  Bands light = this->Rays.highlights().sample(path.at, path.random);
  for (std::size_t b = 0; b < this->Count; ++b)
    light[b] /= probability;
  this->addWeighted(i, light);
}

void WavefrontGather::addVertices(std::size_t i, int blockSize, bool counted)
{
  const LightVertices& pool = *this->Pool.vertices;
  const int trajectories = this->Pool.trajectories;
  if (!this->Rays.pathsOnly())
    for (const VertexSet* set : {&pool.reflected, &pool.glossy})
      this->addBlock(i, *set, blockSize, this->Rays.blockShare(trajectories, blockSize), counted);
  if (this->Rays.usesStarts())
    this->addBlock(i, pool.emitted, blockSize, this->Rays.startShare(trajectories, blockSize), counted);
}

void WavefrontGather::addBlock(std::size_t i, const VertexSet& set, int blockSize, double share, bool counted)
{
  if (set.size() == 0)
    return;
  static_assert(rayBlock <= VertexTile::capacity && cellBlock <= VertexTile::capacity, "a block is scored as one tile");
  // A run of vertices from a random start, wrapped at the end, so that each vertex has the same probability.
  const std::size_t size = std::min<std::size_t>(blockSize, set.size());
  const auto begin = static_cast<std::size_t>(this->Paths[i].random.next() * static_cast<double>(set.size()));
  const std::size_t straight = std::min(size, set.size() - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size) / this->Pool.trajectories;
  this->addRun(i, set, begin, straight, share, weight, counted);
  if (straight < size)
    this->addRun(i, set, 0, size - straight, share, weight, counted);
}

void WavefrontGather::addRun(std::size_t i, const VertexSet& set, std::size_t begin, std::size_t count, double share,
                             double weight, bool counted)
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
    this->addIfSeen(i, pick.target, pick.light, counted);
  else
    this->addWeighted(i, pick.light);
}

void WavefrontGather::addWeighted(std::size_t i, const Bands& light)
{
  for (std::size_t b = 0; b < this->Count; ++b)
    this->found(i)[b] += this->Paths[i].throughput[b] * light[b];
}

void WavefrontGather::addIfSeen(std::size_t i, const RayAnchor& target, const Bands& light, bool counted)
{
  const PathState& path = this->Paths[i];
  // A NaN skips the shadow test, so that checkFinite() reports it.
  if (!this->Rays.shadows() || std::isnan(light[0]))
    return this->addWeighted(i, light);
  this->Pending.add(i, {path.at.anchor, target, path.doublePrecision}, path.throughput, light, counted);
  if (counted)
    this->Picked[i].add({photometric(light, static_cast<int>(this->Count)), 1, 0});
}

void WavefrontGather::addSeen()
{
  this->Pending.settle(this->Rays.scene().rays(), [this](std::size_t i, const double* light, bool counted) {
    for (std::size_t b = 0; b < this->Count; ++b)
      this->found(i)[b] += light[b];
    this->Picked[i].seen += counted;
  });
}
}  // namespace kalos
