// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CameraPreset.h"

#include <QJsonArray>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "base/JsonFields.h"

namespace studio
{
namespace
{
QJsonArray array(const Point& values)
{
  return {values[0], values[1], values[2]};
}
}  // namespace

double CameraPreset::verticalAngle(double shape) const
{
  if (shape >= 1)
    return this->fieldOfView;
  return 2 * qRadiansToDegrees(std::atan(std::tan(qDegreesToRadians(this->fieldOfView) / 2) / shape));
}

QJsonObject CameraPreset::toJson() const
{
  return {{QStringLiteral("position"), array(this->position)},
          {QStringLiteral("target"), array(this->target)},
          {QStringLiteral("up"), array(this->up)},
          {QStringLiteral("fov_deg"), this->fieldOfView}};
}

CameraPreset CameraPreset::fromJson(const QJsonObject& object, const QString& where)
{
  CameraPreset camera;
  JsonFields fields(object, where);
  fields.numbers(QStringLiteral("position"), camera.position.GetData(), 3);
  fields.numbers(QStringLiteral("target"), camera.target.GetData(), 3);
  fields.numbers(QStringLiteral("up"), camera.up.GetData(), 3);
  fields.number(QStringLiteral("fov_deg"), camera.fieldOfView, 0.1, 179);
  fields.finish();
  return camera;
}

CameraPreset fitted(const double bounds[6], const Point& direction, const Point& up, double shape)
{
  CameraPreset camera;
  camera.fieldOfView = 35;
  const Point ahead = direction.Normalized(), across = ahead.Cross(up).Normalized(), upright = across.Cross(ahead);
  constexpr double margin = 1.06;
  const double least = std::tan(qDegreesToRadians(camera.fieldOfView) / 2) / margin,
               wide = least * std::max(1.0, shape), high = least * std::max(1.0, 1 / shape);
  const Point low{bounds[0], bounds[2], bounds[4]}, extent = Point{bounds[1], bounds[3], bounds[5]} - low;
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    Point from;  // the middle of the box
    for (int axis = 0; axis < 3; ++axis)
      from[axis] = (corner >> axis & 1 ? 0.5 : -0.5) * extent[axis];
    distance = std::max({distance, std::abs(from.Dot(across)) / wide - from.Dot(ahead),
                         std::abs(from.Dot(upright)) / high - from.Dot(ahead)});
  }
  camera.target = low + 0.5 * extent;
  camera.position = camera.target - distance * ahead;
  camera.up = up;
  return camera;
}
}  // namespace studio
