// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of light (light subpaths), from the emitters until absorption or escape.
#ifndef kalos_estimator_tracing_Trajectories_h
#define kalos_estimator_tracing_Trajectories_h

#include "estimator/tracing/Emission.h"
#include "estimator/tracing/EnergyBalance.h"
#include "estimator/tracing/VertexSet.h"

namespace kalos
{
/// Vertices of a run of trajectories of one replicate.
struct LightVertices
{
  VertexSet reflected;  ///< collisions with Lambertian surfaces: flux = reflectance times incident weight
  VertexSet glossy;     ///< collisions with glossy surfaces: flux = incident weight, with its direction
  VertexSet emitted;    ///< starts on emitting meshes: flux = emitted flux
  EnergySums energy;    ///< of the trajectories

  explicit LightVertices(int bands = 1, std::size_t surfaces = 0)
      : reflected(bands), glossy(bands), emitted(bands), energy(surfaces)
  {
  }
  void append(const LightVertices& other);
};

/// Replicates from this number on enter no estimate, so decisions based on them add no bias.
constexpr int pilotReplicate = 1 << 20;

/// One step of a trajectory, for direct simulation and photon maps.
struct Segment
{
  Vec3 from, to;  ///< `to` lies just behind the surface that is hit, or far outside when it leaves the scene
  Vec3 direction;
  Bands weight;      ///< lm if the trajectory were the only one
  bool first;        ///< straight from the emitter
  bool fromMesh;     ///< of the trajectory: it starts on an emitting mesh
  bool byMirrors;    ///< from a point luminaire by mirrors alone, one or more
  SurfacePoint end;  ///< what is hit
};

/// Traces trajectories [first, first + count) of a replicate. Ended by Russian roulette on the luminous share that a
/// surface reflects, never by a depth limit.
LightVertices traceTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                                long long first, int count);

/// The same trajectories, segment by segment. Returns their energy balance.
EnergySums walkTrajectories(const Scene& scene, const Emission& emission, const Walks& walks, int replicate,
                            long long first, int count, const std::function<void(const Segment&)>& visit);
}  // namespace kalos

#endif
