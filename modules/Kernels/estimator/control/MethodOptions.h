// SPDX-License-Identifier: BSD-3-Clause
// What single methods let a user choose; the other methods ignore it.
#ifndef kalos_estimator_control_MethodOptions_h
#define kalos_estimator_control_MethodOptions_h

namespace kalos
{
struct MethodOptions
{
  int photons = 0;           ///< `photon-map`: the nearest so many; 0: those within a radius
  bool coneFilter = false;   ///< `photon-map`: photons count less the farther they are
  bool finalGather = false;  ///< `photon-map`: the map is seen by rays from the receivers, not read at them
};
}  // namespace kalos

#endif
