// SPDX-License-Identifier: BSD-3-Clause
// Also known as: pilot run; density estimation of the light vertices.
//
// Estimates the density of vertices from a few trajectories that no estimate uses, so that sample numbers and weights
// do not depend on samples of the result.
#ifndef kalos_estimator_tracing_VertexDensity_h
#define kalos_estimator_tracing_VertexDensity_h

#include "estimator/tracing/Trajectories.h"

namespace kalos
{
/// Densities in vertices per m2 and trajectory.
class VertexDensity
{
public:
  VertexDensity(const Scene& scene, const Emission& emission, const Walks& walks);

  /// Collisions per trajectory.
  double collisions() const { return this->Collisions; }
  /// Starts on emitting meshes per trajectory.
  double starts() const { return this->Starts; }

  /// Density of collisions about the point p of a surface, from an octree over the pilot's vertices: right within a
  /// small factor, positive everywhere.
  double density(const Vec3& p) const;

  /// Density of starts on an emitting material; exact.
  double startDensity(const Material& material) const;

  /// Density about the median vertex.
  double typical() const { return this->Typical; }

  /// Notes the density at every vertex of a pool; for first hits of luminaires theirs, where it is larger.
  void annotate(LightVertices& pool) const;

private:
  struct Node
  {
    int children = -1;   // index of the first of eight, or none
    double density = 0;  // of the smallest cube about here that holds enough vertices
  };
  struct Collision
  {
    Vec3 position, normal;
  };
  void split(int node, const Vec3& centre, double half, const std::vector<Collision>& inside, int depth);
  static double densityIn(double side, const std::vector<Collision>& inside);

  const Scene& Scene_;
  double Flux, Collisions = 0, Starts = 0, Typical = 0;
  std::vector<Node> Nodes;
};
}  // namespace kalos

#endif
