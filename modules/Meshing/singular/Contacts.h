// SPDX-License-Identifier: BSD-3-Clause
/** Contact curves: where triangles without a common edge touch or cross. */
#ifndef KalosMeshingContacts_h
#define KalosMeshingContacts_h

#include "mesh/Tolerances.h"
#include "singular/SingularEdges.h"

namespace kalos::meshing
{
/**
 * Appends the pieces along which two triangles that share no edge, and are not parallel, meet, and which have a
 * severity: each piece once, however many pairs of triangles meet there, with the severest of their angles.
 *
 * Surfaces nearer than the tolerances of both touch. The mesh has merged points and no degenerate or duplicate
 * triangles.
 */
void appendContacts(const TriangleMesh& mesh, const Tolerances& tolerances, const EdgeSettings& settings,
                    std::vector<Segment>& pieces, const Progress& progress);

/** The piece along which two triangles meet; false if they meet in a point, in an area or not at all. */
bool intersect(const TriangleMesh& mesh, const Triangle& a, const Triangle& b, double distance,
               const EdgeSettings& settings, Segment& piece);

/** Joins overlapping pieces of one line, so that no part of it is there twice. */
std::vector<Segment> joinOverlaps(const std::vector<Segment>& pieces, double distance);
}  // namespace kalos::meshing

#endif
