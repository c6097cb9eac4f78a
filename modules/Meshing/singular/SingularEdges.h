// SPDX-License-Identifier: BSD-3-Clause
/** Where the geometric kernel turns singular: concave edges, and contacts of surfaces that share no edge. */
#ifndef KalosMeshingSingularEdges_h
#define KalosMeshingSingularEdges_h

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
enum class EdgeClass : std::uint8_t
{
  Concave = 0,      ///< the front angle is below a straight one
  Convex = 1,       ///< the front angle is above a straight one
  Coplanar = 2,     ///< straight within the flat angle
  Border = 3,       ///< one triangle
  NonManifold = 4,  ///< three or more triangles
  Contact = 5       ///< two surfaces touch or cross here and share no edge
};
constexpr int numberOfEdgeClasses = 6;

/** Angles in radians, 0 to 2 pi. The front is the side the normals point to; of two that disagree, the narrower one. */
struct EdgeProperties
{
  EdgeClass kind = EdgeClass::Coplanar;
  double front = 0.0;     ///< angle on the front; 2 pi at borders; smallest one where three or more surfaces meet
  double back = 0.0;      ///< angle on the back
  double severity = 0.0;  ///< cot²(α/2)/4, see EdgeAngles.h
};

struct Segment
{
  Point start, end;
  EdgeProperties edge;
};

/** A straight run of edges with the same properties: `first` and the `count` of its entries in Curves::indices. */
struct Curve
{
  std::size_t first = 0, count = 0;
  EdgeProperties edge;
};

struct EdgeSettings
{
  double tolerance = 0.0;  ///< distance below which points are one and surfaces touch, m; 0: see Tolerances.h
  double flat = 0.5 * 3.14159265358979323846 / 180.0;  ///< deviation from a straight angle that counts as none, radians
  bool bothSides = false;                              ///< judge an edge by the narrower of its sides, not by its front
  std::array<bool, numberOfEdgeClasses> wanted{true, false, false, false, true, true};  ///< classes to return
};

struct EdgeReport
{
  std::array<std::size_t, numberOfEdgeClasses> edges{};  ///< mesh edges of each class, wanted or not; contacts: pieces
  std::size_t degenerate = 0, duplicate = 0;             ///< triangles left out of the search
  std::size_t inconsistent = 0;                          ///< edges whose two triangles face opposite ways
  double tolerance = 0.0;                                ///< the largest that was used, m
};

struct Curves
{
  std::vector<Point> points;
  std::vector<std::uint32_t> indices;
  std::vector<Curve> curves;
  EdgeReport report;
};

/**
 * Finds the edges of a mesh that may be any soup: points need not be merged, surfaces may touch, cross or be
 * non-manifold. Neighbours are found by half-edges, where half-edges cannot store them by sorting, contacts by
 * intersecting bounding boxes, all in O(n log n) for a mesh whose triangles meet few others. Throws as check() and
 * report() do.
 *
 * Within the tolerance: surfaces closer than it touch, contacts shorter than four times it count as points,
 * and where two edges cross at an angle the ends of a contact are right to a few tolerances over its sine.
 */
Curves findSingularEdges(TriangleMesh mesh, const EdgeSettings& settings, const Progress& progress = {});
}  // namespace kalos::meshing

#endif
