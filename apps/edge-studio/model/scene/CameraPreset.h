// SPDX-License-Identifier: BSD-3-Clause
// A viewpoint.
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

  /// The vertical field of view of a picture with this ratio of width to height, degrees.
  double verticalAngle(double shape) const;

  QJsonObject toJson() const;  ///< the name apart
  /// Throws Problem.
  static CameraPreset fromJson(const QJsonObject& object, const QString& where);
};

/// A viewpoint that shows all of a box (bounds as of vtkDataSet) along a direction, in a picture of this ratio of width
/// to height.
CameraPreset fitted(const double bounds[6], const Point& direction, const Point& up, double shape);
}  // namespace studio

#endif
