// SPDX-License-Identifier: BSD-3-Clause
// The luminance that a camera sees, gloss and mirrors included, as it is refined.
#ifndef studio_CameraImage_h
#define studio_CameraImage_h

#include <QObject>
#include <memory>

#include "Run.h"

class vtkImageData;

namespace studio
{
class CameraImage : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  /// Stops what is under way, and begins anew.
  void start(const ScenePtr& scene, const CameraPreset& camera, int width, int height, const MethodSettings& settings);
  void cancel();
  void forget();  ///< stops at once, without a signal; no result
  bool active() const { return this->Current && this->Current->active(); }

  const Run* run() const { return this->Current.get(); }  ///< the last one started; null before
  ResultPtr result() const { return this->Latest; }
  vtkImageData* data() const;  ///< of the result, row 0 at the bottom; null where there is none

signals:
  void changed();
  void problem(const QString& message);

private:
  std::unique_ptr<Run> Current;
  ResultPtr Latest;
};
}  // namespace studio

#endif
