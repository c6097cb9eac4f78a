// SPDX-License-Identifier: BSD-3-Clause
// Several runs, one after the other.
#ifndef studio_RunQueue_h
#define studio_RunQueue_h

#include <QObject>
#include <QVector>
#include <memory>

#include "run/Run.h"

namespace studio
{
class RunQueue : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  struct Job
  {
    vtkSmartPointer<vtkDataObject> receivers;
    MethodSettings settings;
  };

  /// Stops what is under way, forgets its results and begins anew.
  void start(const ScenePtr& scene, const QVector<Job>& jobs);
  void cancel();
  void forget();  ///< stops at once, without a signal; no results
  bool active() const { return this->Current != nullptr; }

  /// One per job, null while it has none.
  const QVector<ResultPtr>& results() const { return this->Results; }
  const QVector<Job>& jobs() const { return this->Jobs; }
  int finished() const { return this->At; }  ///< jobs that are done

signals:
  void refined(int job);
  void ended();  ///< all done, or cancelled, or failed
  void failed(const QString& problem);

private:
  void next();

  ScenePtr Scene;
  QVector<Job> Jobs;
  QVector<ResultPtr> Results;
  int At = 0;
  std::unique_ptr<Run> Current;
};
}  // namespace studio

#endif
