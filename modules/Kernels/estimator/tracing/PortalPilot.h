// SPDX-License-Identifier: BSD-3-Clause
// Finds small openings between the light and the receivers.
//
// Paths from the receivers and trajectories divide the surfaces into regions (RegionMap). Where most regions that the
// receivers reach are lit, there is nothing to find. Else longer runs look for segments from a region that is lit into
// one that is not: these pass an opening. What hides their ends when these are moved a little gives planes; the plane
// in which the segments lie closest together holds the opening, and rays through it say how large it is.
//
// The pilot's random numbers enter no estimate. It takes some hundred rays in a room without such regions.
#ifndef kalos_estimator_tracing_PortalPilot_h
#define kalos_estimator_tracing_PortalPilot_h

#include "estimator/control/Settings.h"
#include "estimator/kernel/Sensor.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
Portals findPortals(const Scene& scene, const Emission& emission, const std::vector<Sensor>& sensors,
                    const Walks& walks);
}  // namespace kalos

#endif
