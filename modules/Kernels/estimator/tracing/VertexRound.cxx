// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/tracing/VertexRound.h"

#include "estimator/tracing/VertexOrder.h"

namespace kalos
{
std::vector<LightVertices> traceRound(const Scene& scene, const Emission& emission, const Walks& walks, int replicates,
                                      long long first, int count, Workers& workers)
{
  constexpr int chunkSize = 512;  // trajectories traced by one task
  const int chunksEach = (count + chunkSize - 1) / chunkSize;
  std::vector<LightVertices> chunks(static_cast<std::size_t>(replicates) * chunksEach);
  const bool traced = workers.forEachReplicate(replicates, chunksEach, [&](int replicate, std::size_t chunk) {
    const int begin = static_cast<int>(chunk) * chunkSize;
    chunks[replicate * chunksEach + chunk] =
        traceTrajectories(scene, emission, walks, replicate, first + begin, std::min(chunkSize, count - begin));
  });
  if (!traced)
    return {};

  // Join the chunks of each replicate in their order, so that no sum depends on the threads.
  std::vector<LightVertices> pools(replicates, LightVertices(scene.bands(), scene.surfaces()));
  const bool joined = workers.forEachReplicate(replicates, 1, [&](int p, std::size_t) {
    for (int c = 0; c < chunksEach; ++c)
      pools[p].append(chunks[p * chunksEach + c]);
    if (emission.hasStrata())
      for (VertexSet* set : {&pools[p].reflected, &pools[p].glossy, &pools[p].emitted})
        separateStrata(*set);
    if (walks.sampling != Sampling::Independent)
      for (VertexSet* set : {&pools[p].reflected, &pools[p].glossy, &pools[p].emitted})
        spreadOverLanes(*set);
  });
  return joined ? std::move(pools) : std::vector<LightVertices>();
}
}  // namespace kalos
