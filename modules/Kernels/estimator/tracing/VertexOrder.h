// SPDX-License-Identifier: BSD-3-Clause
// The order of the vertices of a set, by which picks among them and runs of them are spread over space.
//
// To the same error of the mean a solve by `compensated` took 12 to 20 % less time than with vertices as they were
// traced, on a floor, a plane and all walls of a furnished room and on a plane 1 mm off a wall, 4 % less in an office
// of 275 000 triangles; `gathered` took the same. A finer order within each lane gave no further gain.
#ifndef kalos_estimator_tracing_VertexOrder_h
#define kalos_estimator_tracing_VertexOrder_h

#include "estimator/tracing/VertexSet.h"

namespace kalos
{
/// Gives each lane of each VertexTile a part of space of its own, by halving the vertices across the longest side of
/// their box. Systematic picks, which go through lane after lane, are stratified over space then, and so is a run of
/// vertices, which has some of every lane. Vertices stay in their tile, and those of a lane in their order.
void spreadOverLanes(VertexSet& set);

/// Puts the vertices of each stratum together, in their order. Picks among the vertices of one stratum, in proportion
/// to unshadowed scores, do not miss the dim vertices of a receiver's own room for bright ones next door.
void separateStrata(VertexSet& set);
}  // namespace kalos

#endif
