// SPDX-License-Identifier: BSD-3-Clause
// Counts traced rays at almost no cost: every thread has its own counter.
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
