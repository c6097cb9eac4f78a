// SPDX-License-Identifier: BSD-3-Clause
// The receivers: points where illuminance is estimated.
#ifndef kalos_estimator_control_Receivers_h
#define kalos_estimator_control_Receivers_h

#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
class Brdf;

/// Points where illuminance is estimated, in world coordinates.
struct Receivers
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals;             ///< unit
  std::vector<std::vector<Vec3>> cells;  ///< corners of each receiver's own polygon; empty, or an empty cell: a point
  /// Empty (or not complete: not known), or m from where the kernel is singular: as far as a right-angled edge with the
  /// same kernel at that place would be, the distance over cot(alpha/2) of an edge of angle alpha. The audit holds it
  /// against what is gathered.
  std::vector<double> edgeDistances;
  std::vector<const Brdf*> brdfs;   ///< empty, or one each: not null asks for pi L reflected into `outgoing` instead
  std::vector<Vec3> outgoing;       ///< unit, with brdfs
  std::vector<char> followsMirror;  ///< 0: without the mirror part; with brdfs
};

}  // namespace kalos

#endif
