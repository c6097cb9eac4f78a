// SPDX-License-Identifier: BSD-3-Clause
// The light of a whole set of vertices at a receiver.
#ifndef kalos_estimator_gathering_VertexScores_h
#define kalos_estimator_gathering_VertexScores_h

#include "estimator/gathering/GatherContext.h"
#include "estimator/kernel/Sensor.h"
#include "estimator/tally/Tally.h"

namespace kalos
{
/// Adds the scores of a pool's vertices at receiver r to the tally. `share`: gather rays of the receiver per
/// trajectory, as they count for G*. Those on emitting meshes are left out where their light is known exactly.
void addVertexScores(const GatherContext& gathering, const LightVertices& pool, const Sensor& sensor, double share,
                     bool exactMeshes, RandomStream random, std::size_t r, int replicate, Tally& tally);
}  // namespace kalos

#endif
