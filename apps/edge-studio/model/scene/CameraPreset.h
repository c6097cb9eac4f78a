// SPDX-License-Identifier: BSD-3-Clause
// Where one looks from.
#ifndef studio_CameraPreset_h
#define studio_CameraPreset_h

#include <QJsonObject>
#include <QString>

#include "base/Point.h"

namespace studio
{
struct CameraPreset
{
  QString name;
  Point position{0, -1, 0}, target{0, 0, 0}, up{0, 0, 1};
  double fieldOfView = 45;  ///< across the smaller side of the picture, degrees

  /// From the bottom to the top of a picture of this width over height, degrees.
  double verticalAngle(double shape) const;

  QJsonObject toJson() const;  ///< the name apart
  /// Throws Problem.
  static CameraPreset fromJson(const QJsonObject& object, const QString& where);
};

/// Sees all of a box (as vtkDataSet::GetBounds() gives it) along a direction, in a picture of this width over height.
CameraPreset fitted(const double bounds[6], const Point& direction, const Point& up, double shape);
}  // namespace studio

#endif
