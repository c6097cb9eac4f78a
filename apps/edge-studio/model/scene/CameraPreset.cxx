// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CameraPreset.h"

#include <QJsonArray>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "base/JsonFields.h"
#include "vtkMath.h"

namespace studio
{
namespace
{
QJsonArray array(const std::array<double, 3>& values)
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
  fields.numbers(QStringLiteral("position"), camera.position.data(), 3);
  fields.numbers(QStringLiteral("target"), camera.target.data(), 3);
  fields.numbers(QStringLiteral("up"), camera.up.data(), 3);
  fields.number(QStringLiteral("fov_deg"), camera.fieldOfView, 0.1, 179);
  fields.finish();
  return camera;
}

CameraPreset fitted(const double bounds[6], const std::array<double, 3>& direction, const std::array<double, 3>& up,
                    double shape)
{
  CameraPreset camera;
  camera.fieldOfView = 35;
  std::array<double, 3> ahead = direction, across, upright;
  vtkMath::Normalize(ahead.data());
  vtkMath::Cross(ahead.data(), up.data(), across.data());
  vtkMath::Normalize(across.data());
  vtkMath::Cross(across.data(), ahead.data(), upright.data());
  constexpr double margin = 1.06;
  const double least = std::tan(qDegreesToRadians(camera.fieldOfView) / 2) / margin,
               wide = least * std::max(1.0, shape), high = least * std::max(1.0, 1 / shape);
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<double, 3> from;  // the middle of the box
    for (int axis = 0; axis < 3; ++axis)
      from[axis] = (corner >> axis & 1 ? 0.5 : -0.5) * (bounds[2 * axis + 1] - bounds[2 * axis]);
    distance = std::max(
        {distance, std::abs(vtkMath::Dot(from.data(), across.data())) / wide - vtkMath::Dot(from.data(), ahead.data()),
         std::abs(vtkMath::Dot(from.data(), upright.data())) / high - vtkMath::Dot(from.data(), ahead.data())});
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    camera.target[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
    camera.position[axis] = camera.target[axis] - distance * ahead[axis];
  }
  camera.up = up;
  return camera;
}
}  // namespace studio
