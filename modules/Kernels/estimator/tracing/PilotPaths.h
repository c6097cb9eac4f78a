// SPDX-License-Identifier: BSD-3-Clause
// Paths of light and paths from receivers, as the pilots use them.
#ifndef kalos_estimator_tracing_PilotPaths_h
#define kalos_estimator_tracing_PilotPaths_h

#include <functional>

#include "estimator/kernel/Sensor.h"
#include "estimator/tracing/Emission.h"

namespace kalos
{
/// One surface point of a path.
struct PilotPoint
{
  SurfacePoint point;
  bool fromReceivers = false;
  std::size_t sensor = 0;  ///< of a path from receivers
  bool first = false;      ///< straight from an emitter or a sensor
  SurfacePoint before;     ///< of the path, unless first
  double flux = 0;         ///< lm that the point reflects, if its trajectory were the only one; of light
};
using VisitPilotPoint = std::function<void(const PilotPoint&)>;

/// Trajectories [first, first + count) of a replicate, without portals.
void visitLight(const Scene& scene, const Emission& emission, const Walks& walks, int replicate, long long first,
                int count, const VisitPilotPoint& visit);

/// As many paths from the sensors in turn, each reflected as if it were light.
void visitImportance(const Scene& scene, const std::vector<Sensor>& sensors, const Walks& walks, int replicate,
                     long long first, int count, const VisitPilotPoint& visit);
}  // namespace kalos

#endif
