// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of light and the vertices they leave on the surfaces.
#ifndef kalos_estimator_Trajectories_h
#define kalos_estimator_Trajectories_h

#include <vector>

#include "estimator/Emission.h"

namespace kalos
{
/// Vertices in structure-of-arrays form, single precision, about the scene's origin. A vertex sends the flux M (lm per
/// band, if its trajectory were the only one) from p into the hemisphere about n, as a Lambertian surface does.
struct VertexSet
{
  std::vector<float> px, py, pz, nx, ny, nz;
  std::vector<float> offset;             ///< m along n to where shadow rays start
  std::vector<std::vector<float>> flux;  ///< M, one array per band

  explicit VertexSet(int bands = 1) : flux(bands) {}
  std::size_t size() const { return this->px.size(); }
  void add(const Scene& scene, const Vec3& p, const Vec3& n, const Bands& m);
};

/// Vertices of a run of trajectories of one replicate.
struct TrajectoryChunk
{
  VertexSet reflected;  ///< collisions: M = reflectance times incident weight
  VertexSet emitted;    ///< starts on emitting meshes: M = emitted flux
};

/// One step of a trajectory, told to whoever simulates directly.
struct Segment
{
  Vec3 from, to;  ///< `to` lies just behind the surface that is hit, or far outside when it leaves the scene
  Vec3 direction;
  Bands weight;  ///< lm if the trajectory were the only one
  bool first;    ///< straight from the emitter
};

/// Traces trajectories [first, first + count) of a replicate. Ended by Russian roulette on the luminous share that a
/// surface reflects, never by a depth limit.
TrajectoryChunk traceTrajectories(const Scene& scene, const Emission& emission, std::uint64_t seed, int replicate,
                                  long long first, int count);

/// The same trajectories, segment by segment.
void walkTrajectories(const Scene& scene, const Emission& emission, std::uint64_t seed, int replicate, long long first,
                      int count, const std::function<void(const Segment&)>& visit);
}  // namespace kalos

#endif
