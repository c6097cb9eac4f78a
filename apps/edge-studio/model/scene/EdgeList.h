// SPDX-License-Identifier: BSD-3-Clause
// The singular edges of a scene, the worst first, and the two faces that meet at one.
#ifndef studio_EdgeList_h
#define studio_EdgeList_h

#include <array>

#include "scene/NearestEdge.h"

namespace studio
{
/// A straight piece of a singular edge.
struct EdgePiece
{
  Point from, to;
  double angle;  ///< degrees, on the side of the normals
  double severity;
  bool contact;

  Point middle() const { return 0.5 * (from + to); }
  double length() const { return (to - from).Norm(); }
};

/// Sorted by severity, then by length; pieces that continue each other are one.
QVector<EdgePiece> edgePieces(const SceneDocument& scene);

/// A face beside an edge.
struct Flank
{
  Point normal;
  Point away;  ///< unit, in the face, from the edge at a right angle
};

/// The two faces that see each other across the edge; nothing where they are not found.
std::optional<std::array<Flank, 2>> flanksOf(const SceneDocument& scene, const EdgePiece& edge);
}  // namespace studio

#endif
