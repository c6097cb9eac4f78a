// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPreset.h"

#include <QJsonArray>
#include <QtMath>
#include <cmath>

#include "JsonFields.h"

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
}  // namespace studio
