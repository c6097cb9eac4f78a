// SPDX-License-Identifier: BSD-3-Clause
// The two halves of a bidirectional path, and the shares of the ways to join them (multiple importance sampling).
//
// A path p_0, p_1, ... p_n, p_n+1 leads from the receiver p_0 by n surfaces to a point p_n+1 of an emitter. Connection
// m takes p_1 ... p_m from the receiver's half and the rest from the light's: m = 0 is the local estimate, m = 1 the
// double one, ..., m = n next event estimation, m = n+1 a receiver's half that meets an emitting mesh. In going from
// m-1 to m the density of p_m changes from that of a trajectory, d_L, to that of a receiver's ray, d_R (per m2), so
// that the balance heuristic's shares are in proportion to the products of d_R/d_L over p_1 ... p_m.
#ifndef kalos_estimator_methods_BidirectionalPath_h
#define kalos_estimator_methods_BidirectionalPath_h

#include <vector>

#include "estimator/kernel/Sensor.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
/// A surface point of either half.
struct PathNode
{
  RayAnchor anchor;
  const Brdf* brdf;
  std::uint32_t triangle;
  Vec3 incident;          ///< unit, towards where the half comes from: the receiver or the light
  Bands weight{};         ///< of the receiver's half: throughput; of the light's: incident flux, lm
  bool mirror = false;    ///< the half goes on by the mirror: nothing joins it here
  bool byMirror = false;  ///< it was reached by the mirror
};

/// The light's half: one trajectory.
struct LightHalf
{
  EmissionSample start;
  std::vector<PathNode> nodes;
};

/// The whole path of one connection. The halves must outlive it.
class JoinedPath
{
public:
  /// Takes the first m nodes of the receiver's half and the first `surfaces` of the light's. `hit`: the m-th node of
  /// the receiver's half is itself the point of the emitter, on a mesh; then no light's half counts.
  JoinedPath(const Scene& scene, const Emission& emission, const Sensor& receiver, const std::vector<PathNode>& nodes,
             std::size_t m, const LightHalf& light, std::size_t surfaces, bool hit);

  /// The share of this connection: by the balance heuristic, or with `only` > 0 all or nothing, as the connection is
  /// the one with most nodes of the receiver's half among those with less than `only`, or with least where none has.
  double share(int only) const;

private:
  struct Node
  {
    Vec3 position, normal;
    const Brdf* brdf = nullptr;  // null at the receiver and at the emitter
    bool mirror = false;
  };
  bool joins(std::size_t m) const;
  bool isChosen(int only) const;
  double startDensity() const;               // of trajectories on the emitting mesh, per m2
  double fromReceiver(std::size_t k) const;  // d_R of node k
  double fromLight(std::size_t k) const;     // d_L
  double density(std::size_t at, std::size_t before, std::size_t to) const;
  double perArea(std::size_t from, std::size_t to, double perSteradian) const;

  const Scene& Scene_;
  const Emission& Source;
  const Sensor& Receiver;
  std::vector<Node> Nodes;           // p_0 ... p_n+1
  const Luminaire* Lamp = nullptr;   // of the emitter; null: a mesh
  std::uint32_t Triangle = 0;        // of the mesh
  std::size_t Connection, Surfaces;  // m, n
  bool Meets;                        // m = n+1 is possible
};

/// Part of an emitter's flux per sr that leaves p in the unit direction, of a luminaire or (null) a mesh of normal n.
double emissionDensity(const Luminaire* luminaire, const Vec3& n, const Vec3& direction);
}  // namespace kalos

#endif
