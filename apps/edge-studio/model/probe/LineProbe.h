// SPDX-License-Identifier: BSD-3-Clause
// Illuminance along a line across an edge, by every method, against the truth or a reference.
#ifndef studio_LineProbe_h
#define studio_LineProbe_h

#include "results/Chart.h"
#include "run/RunQueue.h"
#include "scene/NearestEdge.h"

namespace studio
{
class LineProbe : public QObject
{
  Q_OBJECT

public:
  explicit LineProbe(QObject* parent = nullptr);

  /// Runs every method with the effort, delta and epsilon of `settings`. Where the truth is not known, compensated with
  /// eight times the trajectories and another seed is the reference, first. Seeds differ, so that errors are
  /// independent.
  void start(const ScenePtr& scene, const ProbeLine& line, const MethodSettings& settings);
  void cancel() { this->Queue.cancel(); }
  void forget()  ///< stops, and is as new
  {
    this->Queue.forget();
    this->Line.reset();
  }
  bool active() const { return this->Queue.active(); }
  int finished() const { return this->Queue.finished(); }
  int count() const { return static_cast<int>(this->Queue.jobs().size()); }

  const std::optional<ProbeLine>& line() const { return this->Line; }
  Chart chart() const;

signals:
  void changed();
  void problem(const QString& message);

private:
  RunQueue Queue;
  std::optional<ProbeLine> Line;
  std::optional<double> Truth;
};
}  // namespace studio

#endif
