// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/gathering/VertexScores.h"

#include "estimator/kernel/VertexResampling.h"

namespace kalos
{
namespace
{
// Scoring a pair costs next to nothing, a shadow ray about as much as forty pairs: of 8, 16, 24, 32 and 64 this gave
// the least variance per second on a plane and on the floor of a furnished room.
constexpr int verticesPerPick = 16;
}  // namespace

void addVertexScores(const GatherContext& gathering, const LightVertices& pool, const Sensor& sensor, double share,
                     bool exactMeshes, RandomStream random, std::size_t r, int replicate, Tally& tally)
{
  const RayScene* rays = gathering.shadows() ? &gathering.scene().rays() : nullptr;
  PickCount& counted = tally.picks(r, replicate);
  auto score = [&](const VertexSet& set, double* sum) {
    for (std::size_t begin = 0; begin < set.size(); begin += VertexTile::capacity)
    {
      const auto count = static_cast<int>(std::min<std::size_t>(VertexTile::capacity, set.size() - begin));
      const int picks = gathering.shadowsEveryPair() ? 0 : (count + verticesPerPick - 1) / verticesPerPick;
      const ShadowPicks shadows{rays, picks, random.next(), &counted};
      tally.noteScore(r, replicate, addResampledScores(set, begin, count, sensor, share, shadows, sum));
    }
  };
  double* total = tally.total(r, replicate);
  score(pool.reflected, total);
  score(pool.glossy, total);
  if (exactMeshes)
    return;
  Bands emitted{};
  score(pool.emitted, emitted.data());
  for (int b = 0; b < tally.bands(); ++b)
  {
    total[b] += emitted[b];
    tally.direct(r, replicate)[b] += emitted[b];
  }
}
}  // namespace kalos
