// SPDX-License-Identifier: BSD-3-Clause
/** Triangle soups made into surfaces. */
#ifndef KalosMeshingSurfaceRepair_h
#define KalosMeshingSurfaceRepair_h

#include <string>

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
struct RepairSettings
{
  double tolerance = 0.0;           ///< distance below which points are one, m; 0: see Tolerances.h
  std::vector<std::uint8_t> sided;  ///< by origin: the triangle's side matters, as it emits; empty: none does
  bool keepSides = false;           ///< turn no triangle
};

struct Unrepaired
{
  std::uint32_t origin;
  const char* reason;
};

/** Counts; lengths in m, areas in m². */
struct RepairReport
{
  std::size_t pointsBefore = 0, pointsAfter = 0, trianglesBefore = 0, trianglesAfter = 0;
  std::size_t pointsMerged = 0, pointsUnused = 0, pointsSplit = 0;
  std::size_t pointsMoved = 0;  ///< points merged that were not at the very same place
  std::size_t degenerate = 0, duplicate = 0;
  std::size_t splitTriangles = 0;  ///< triangles cut where corners of others lay on their border
  std::size_t turned = 0;
  std::size_t borderBefore = 0, borderAfter = 0;            ///< edges of one triangle
  std::size_t nonManifoldBefore = 0, nonManifoldAfter = 0;  ///< edges of three or more
  std::size_t surfaces = 0;                                 ///< connected parts
  double areaBefore = 0.0, areaAfter = 0.0;
  double tolerance = 0.0;                            ///< the largest of any point
  double degenerateArea = 0.0, duplicateArea = 0.0;  ///< of the triangles dropped
  Bounds boundsBefore, boundsAfter;
  std::vector<Unrepaired> unrepaired;
};

/**
 * Repairs a mesh in this order: merge points nearer than the tolerance; drop degenerate triangles (lower than the
 * tolerance) and duplicates of the same material (those whose side matters, of the same side); cut triangles where
 * corners of others lie on their border edges, and so stitch; give each connected surface one side, the one that most
 * of its area has, or that its emitting triangles have; give non-manifold edges and vertices a point for each surface.
 * Triangles stay in the order of their origins.
 *
 * What cannot be repaired stays and is named: duplicates of different materials, surfaces whose emitting triangles
 * disagree. Throws as check() and report() do.
 */
RepairReport repair(TriangleMesh& mesh, const RepairSettings& settings, const Progress& progress = {});

/** Cuts triangles where corners of border edges lie on their own border edges. Returns how many were cut. */
std::size_t splitBorders(TriangleMesh& mesh, const Tolerances& tolerances);

/** Points added for non-manifold edges and vertices. `turned` gets a mark for each triangle that now faces the other
 * way. */
std::size_t orient(TriangleMesh& mesh, std::vector<std::uint8_t>& turned);

/** Edges by their number of triangles. */
struct EdgeCounts
{
  std::size_t border = 0, nonManifold = 0;
};
EdgeCounts countEdges(const TriangleMesh& mesh);
}  // namespace kalos::meshing

#endif
