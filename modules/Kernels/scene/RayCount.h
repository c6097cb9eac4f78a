// SPDX-License-Identifier: BSD-3-Clause
// How many rays have been traced, at next to no cost: every thread counts its own.
#ifndef kalos_scene_RayCount_h
#define kalos_scene_RayCount_h

namespace kalos
{
/// Adds to the count of this thread.
void countRays(int rays);

/// Rays of all threads since the program started; exact while none of them traces.
long long raysTraced();

/// Rays that this thread has traced.
long long raysOfThisThread();
}  // namespace kalos

#endif
