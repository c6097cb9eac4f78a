// SPDX-License-Identifier: BSD-3-Clause
// Points on the floor of the room with boxes, and settings for a quick solve.
#ifndef kalos_tests_FloorPoints_h
#define kalos_tests_FloorPoints_h

#include "Rooms.h"
#include "estimator/control/Receivers.h"
#include "estimator/control/Settings.h"

namespace kalos
{
inline bool underABox(const Vec3& p)
{
  return (p.x > 1 && p.x < 2.2 && p.y > 1 && p.y < 2.4) || (p.x > 3 && p.x < 4.1 && p.y > 2.4 && p.y < 3.4);
}

inline Receivers floorPoints()
{
  Receivers r;
  for (double x : {0.7, 1.6, 2.4, 3.9})
    for (double y : {0.6, 2.1, 4.2})
    {
      r.points.push_back({x, y, 0});
      r.normals.push_back({0, 0, 1});
    }
  return r;
}

inline Settings quick(Method method = Method::Local, long long trajectories = 6400)
{
  Settings s;
  s.disabled.insert(Technique::Paths);  // in furnaces, too
  s.method = method;
  s.trajectories = trajectories;
  return s;
}
}  // namespace kalos

#endif
