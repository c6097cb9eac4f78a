// SPDX-License-Identifier: BSD-3-Clause
// The light of vertices where gather rays end; see estimator/gathering/WavefrontGather.h.
#include "estimator/gathering/WavefrontGather.h"
#include "estimator/kernel/VertexResampling.h"

namespace kalos
{
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
  // A run of vertices from a random start, wrapped at the end of its stratum, so that each vertex has the same
  // probability, but for those of small strata.
  const auto begin = static_cast<std::size_t>(this->Paths[i].random.next() * static_cast<double>(set.size()));
  const std::size_t stratum = set.stratumOf(begin);
  const std::size_t first = set.stratumBegin(stratum), end = set.stratumEnd(stratum);
  const std::size_t size = std::min<std::size_t>(blockSize, end - first), straight = std::min(size, end - begin);
  const double weight = static_cast<double>(set.size()) / static_cast<double>(size) / this->Pool.trajectories;
  this->addRun(i, set, begin, straight, share, weight, counted);
  if (straight < size)
    this->addRun(i, set, first, size - straight, share, weight, counted);
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
    const ShadowPicks all{this->Rays.shadows() ? &this->Rays.scene().rays() : nullptr,
                          0,
                          u,
                          nullptr,
                          &this->Rays.portals(),
                          path.portals};
    addResampledScores(set, begin, static_cast<int>(count), path.at, share, all, pick.light.data());
  }
  else if (!resampleOne(set, begin, static_cast<int>(count), path.at, share, u, pick) ||
           (path.portals && this->Rays.portals().cross(path.portals, path.at.position, pick.target.point)))
    return;
  for (std::size_t b = 0; b < this->Count; ++b)
    pick.light[b] *= weight;
  if (picks)
    this->addIfSeen(i, pick.target, pick.light, counted);
  else
    this->addWeighted(i, pick.light);
}
}  // namespace kalos
