// SPDX-License-Identifier: BSD-3-Clause
// The vertices of one round of trajectories, replicate by replicate.
#ifndef kalos_estimator_tracing_VertexRound_h
#define kalos_estimator_tracing_VertexRound_h

#include "estimator/control/Workers.h"
#include "estimator/tracing/Trajectories.h"

namespace kalos
{
/// Traces trajectories [first, first + count) of every replicate that this rank owns; the pools of the others stay
/// empty. No pools when aborted. Where walks are stratified, so are the vertices of each tile (VertexOrder.h).
std::vector<LightVertices> traceRound(const Scene& scene, const Emission& emission, const Walks& walks, int replicates,
                                      long long first, int count, Workers& workers);

/// Random numbers of one receiver in one replicate; `position` counts what was drawn before in that purpose.
inline RandomStream receiverStream(std::uint64_t seed, int replicate, Purpose purpose, std::size_t receiver,
                                   long long position)
{
  return RandomStream(mixBits(seed) + receiver, static_cast<std::uint64_t>(replicate), purpose,
                      static_cast<std::uint64_t>(position));
}
}  // namespace kalos

#endif
