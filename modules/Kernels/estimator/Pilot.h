// SPDX-License-Identifier: BSD-3-Clause
// A few trajectories that no estimate uses: how dense vertices will lie, so that effort and weights can be chosen on
// samples that do not enter the result.
#ifndef kalos_estimator_Pilot_h
#define kalos_estimator_Pilot_h

#include "estimator/Trajectories.h"

namespace kalos
{
/// Densities in vertices per m2 and trajectory.
class Pilot
{
public:
  Pilot(const Scene& scene, const Emission& emission, const Walks& walks);

  /// Collisions per trajectory.
  double collisions() const { return this->Collisions; }
  /// Starts on emitting meshes per trajectory.
  double starts() const { return this->Starts; }

  /// Density of collisions about the point p of a surface of unit normal n: right within a small factor, positive
  /// everywhere. From k-d trees over the pilot's vertices, one for each of the six directions that a normal is nearest
  /// to, split at the median, so that a small bright surface has leaves of its own wherever it lies. A leaf's vertices
  /// lie in the rectangle that holds them and p, seen along that direction.
  double density(const Vec3& p, const Vec3& n) const;

  /// Density of starts on an emitting material; exact.
  double startDensity(const Material& material) const;

  /// Density about the median vertex.
  double typical() const { return this->Typical; }

  /// Notes the density at every vertex of a pool.
  void annotate(VertexPool& pool) const;

private:
  struct Node
  {
    int axis = -1;  // of the split, whose children follow: below it the first, or none: a leaf
    double split = 0;
    int children = 0;
    Vec3 low, high;  // of the vertices in a leaf
    int count = 0;
  };
  struct Collision
  {
    Vec3 position, normal;
  };
  using Iterator = std::vector<Collision>::iterator;
  void split(std::size_t node, Iterator begin, Iterator end);

  const Scene& Lit;
  double Flux, Collisions = 0, Starts = 0, Typical = 0;
  std::vector<Node> Nodes;  // the roots of the six trees, then the others
};
}  // namespace kalos

#endif
