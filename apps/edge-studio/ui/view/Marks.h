// SPDX-License-Identifier: BSD-3-Clause
// Lines that mark places in the view.
#ifndef studio_Marks_h
#define studio_Marks_h

#include <QVector>

#include "base/Point.h"

namespace studio
{
/// A cross of three lines of twice this size, m.
inline QVector<QVector<Point>> crossAt(const Point& place, double size)
{
  QVector<QVector<Point>> lines;
  for (int axis = 0; axis < 3; ++axis)
  {
    Point arm(0, 0, 0);
    arm[axis] = size;
    lines.append({place - arm, place + arm});
  }
  return lines;
}
}  // namespace studio

#endif
