// SPDX-License-Identifier: BSD-3-Clause
// The luminance that a camera sees, gloss and mirrors included, as it is refined.
#ifndef studio_CameraImage_h
#define studio_CameraImage_h

#include <QObject>
#include <memory>

#include "run/Run.h"

class vtkImageData;

namespace studio
{
/// The request for an image.
struct ImageRequest
{
  CameraPreset camera;
  int width = 0, height = 0;  ///< pixels
  MethodSettings settings;

  QJsonObject toJson() const;
  /// Throws Problem.
  static ImageRequest fromJson(const QJsonObject& object, const QString& where);
};

class CameraImage : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  /// Stops what is under way, and begins anew.
  void start(const ScenePtr& scene, const ImageRequest& request);
  /// Takes over a result that was computed before.
  void restore(const ImageRequest& request, const ResultPtr& result);
  void cancel();
  void forget();  ///< stops at once, without a signal; no result
  bool active() const { return this->Current && this->Current->active(); }

  const Run* run() const { return this->Current.get(); }  ///< the last one started; null before
  const std::optional<ImageRequest>& request() const { return this->Request; }
  ResultPtr result() const { return this->Latest; }
  vtkImageData* data() const;  ///< of the result, row 0 at the bottom; null where there is none

signals:
  void changed();
  void ended();  ///< a run of its own accord, by cancel() or by a failure
  void problem(const QString& message);

private:
  std::optional<ImageRequest> Request;
  std::unique_ptr<Run> Current;
  ResultPtr Latest;
};
}  // namespace studio

#endif
