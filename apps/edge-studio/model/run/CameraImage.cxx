// SPDX-License-Identifier: BSD-3-Clause
#include "run/CameraImage.h"

#include "base/JsonFields.h"
#include "base/Problem.h"
#include "vtkImageData.h"

namespace studio
{
QJsonObject ImageRequest::toJson() const
{
  return {{QStringLiteral("camera"), this->camera.toJson()},
          {QStringLiteral("width"), this->width},
          {QStringLiteral("height"), this->height},
          {QStringLiteral("settings"), this->settings.toJson()}};
}

ImageRequest ImageRequest::fromJson(const QJsonObject& object, const QString& where)
{
  ImageRequest request;
  JsonFields fields(object, where);
  double width = 0, height = 0;
  fields.read(QStringLiteral("camera"), request.camera);
  fields.number(QStringLiteral("width"), width, 1, 16384);
  fields.number(QStringLiteral("height"), height, 1, 16384);
  fields.read(QStringLiteral("settings"), request.settings);
  fields.finish();
  if (width < 1 || height < 1)
    throw Problem(QStringLiteral("%1: has no size, expected width and height in pixels").arg(where));
  request.width = static_cast<int>(width);
  request.height = static_cast<int>(height);
  return request;
}

void CameraImage::start(const ScenePtr& scene, const ImageRequest& request)
{
  this->Request = request;
  this->Current = std::make_unique<Run>(
      planImage(*scene, request.camera, request.width, request.height, request.settings), request.settings);
  connect(this->Current.get(), &Run::progressed, this, &CameraImage::changed);
  connect(this->Current.get(), &Run::refined, this, [this] {
    this->Latest = this->Current->result();
    emit this->changed();
  });
  connect(
      this->Current.get(), &Run::ended, this,
      [this, run = this->Current.get()] {
        if (run != this->Current.get())
          return;  // another one was started meanwhile
        emit this->changed();
        if (run->state() == Run::State::Failed)
          emit this->problem(run->problem());
        emit this->ended();
      },
      Qt::QueuedConnection);
  emit this->changed();
}

void CameraImage::restore(const ImageRequest& request, const ResultPtr& result)
{
  this->Current.reset();
  this->Request = request;
  this->Latest = result;
  emit this->changed();
}

void CameraImage::cancel()
{
  if (this->Current)
    this->Current->cancel();
}

void CameraImage::forget()
{
  this->Request.reset();
  this->Current.reset();
  this->Latest.reset();
}

vtkImageData* CameraImage::data() const
{
  return this->Latest ? vtkImageData::SafeDownCast(this->Latest->data) : nullptr;
}
}  // namespace studio
