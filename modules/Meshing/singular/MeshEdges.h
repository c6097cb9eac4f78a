// SPDX-License-Identifier: BSD-3-Clause
/** The edges that the triangles of a mesh share. */
#ifndef KalosMeshingMeshEdges_h
#define KalosMeshingMeshEdges_h

#include "singular/SingularEdges.h"

namespace kalos::meshing
{
/** Classifies every edge of a mesh with merged points and appends those of the wanted classes. */
void appendMeshEdges(const TriangleMesh& mesh, const EdgeSettings& settings, EdgeReport& report,
                     std::vector<Segment>& segments);

/** Class and severity from the angles; `kind` is kept where it is a contact or non-manifold. */
void classify(EdgeProperties& edge, const EdgeSettings& settings);
}  // namespace kalos::meshing

#endif
