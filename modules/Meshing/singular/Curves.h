// SPDX-License-Identifier: BSD-3-Clause
/** Segments joined end to end. */
#ifndef KalosMeshingCurves_h
#define KalosMeshingCurves_h

#include "singular/SingularEdges.h"

namespace kalos::meshing
{
/** Joins segments with the same properties that continue each other straight on; ends nearer than `distance` are one.
 */
void joinSegments(const std::vector<Segment>& segments, double distance, Curves& result);
}  // namespace kalos::meshing

#endif
