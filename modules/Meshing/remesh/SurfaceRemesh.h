// SPDX-License-Identifier: BSD-3-Clause
/** Surfaces with triangles of wanted size and good shape. */
#ifndef KalosMeshingSurfaceRemesh_h
#define KalosMeshingSurfaceRemesh_h

#include "mesh/TriangleMesh.h"

namespace kalos::meshing
{
struct RemeshSettings
{
  double edgeLength = 0.0;                          ///< m, above 0
  double feature = 3.14159265358979323846 / 180.0;  ///< radians; edges that deviate more from flat are kept
  int iterations = 5;                               ///< of splitting, collapsing, flipping and smoothing
  double smallest = 0.0;                            ///< edge length at singular edges, m; 0: no grading by distance
  double grading = 0.3;                             ///< growth of the edge length with the distance from them, m per m
  std::vector<double> wanted;                       ///< by origin: edge length that the cell wants, m; empty: none does
  std::size_t maximumTriangles = 5000000;           ///< throws when more are to be expected
};

/** Lengths in m, areas in m², angles in radians. */
struct RemeshReport
{
  std::size_t trianglesBefore = 0, trianglesAfter = 0, pointsAfter = 0, patches = 0;
  double areaBefore = 0.0, areaAfter = 0.0;
  double minimumAngle = 0.0;  ///< of all corners
  double smallAngles = 0.0;   ///< share of triangles with an angle below 20 degrees
  double shortest = 0.0, mean = 0.0, longest = 0.0;
  std::array<std::size_t, 8>
      histogram{};  ///< edges by length over the wanted one: 0 to 1/4, 1/4 to 1/2, ..., above 7/4
};

/**
 * Remeshes with CGAL's isotropic remeshing. Kept: borders, edges between materials and between surfaces that face
 * opposite ways, creases sharper than `feature`, and every bend of these lines. So flat faces stay in their planes and
 * keep their area; surfaces that are smooth within `feature` are approximated by points on them. `origin` becomes the
 * nearest triangle of the same patch, `material` is kept, triangles face as they did. The mesh must have neither
 * degenerate nor duplicate triangles: repair() it first; non-manifold edges are split here.
 *
 * Throws std::invalid_argument for an edge length that is not above 0 or that needs too many triangles or more
 * memory than this machine has, and as check()
 * and report() do.
 */
RemeshReport remesh(TriangleMesh& mesh, const RemeshSettings& settings, const Progress& progress = {});

/** Triangles to expect. */
double expectedTriangles(const TriangleMesh& mesh, const RemeshSettings& settings, double singularLength);

/** Angles and edge lengths of a mesh, the lengths in relation to `wanted`. */
void measureQuality(const TriangleMesh& mesh, double wanted, RemeshReport& report);
}  // namespace kalos::meshing

#endif
