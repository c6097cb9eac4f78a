// SPDX-License-Identifier: BSD-3-Clause
#include "CameraImage.h"

#include "vtkImageData.h"

namespace studio
{
void CameraImage::start(const ScenePtr& scene, const CameraPreset& camera, int width, int height,
                        const MethodSettings& settings)
{
  this->Current = std::make_unique<Run>(planImage(*scene, camera, width, height, settings), settings);
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
      },
      Qt::QueuedConnection);
  emit this->changed();
}

void CameraImage::cancel()
{
  if (this->Current)
    this->Current->cancel();
}

void CameraImage::forget()
{
  this->Current.reset();
  this->Latest.reset();
}

vtkImageData* CameraImage::data() const
{
  return this->Latest ? vtkImageData::SafeDownCast(this->Latest->data) : nullptr;
}
}  // namespace studio
