// SPDX-License-Identifier: BSD-3-Clause
// Studies one point: the convergence of its estimate, and the contributions of single trajectories.
#ifndef studio_Probe_h
#define studio_Probe_h

#include "results/Chart.h"
#include "run/RunQueue.h"
#include "scene/NearestEdge.h"

namespace studio
{
/// A value with its standard error.
struct Estimate
{
  double value = 0, error = 0;  ///< lx
  bool trusted = true;
  bool dark() const { return this->value == 0 && this->error == 0; }  ///< nothing was scored: the error is not known
};
Estimate estimateAt(const Result& result, vtkIdType receiver);

/// Half-width of a 95 % interval over the standard error, for the 32 replicates of a solve (Student, 31 degrees).
constexpr double interval95 = 2.04;

class Probe : public QObject
{
  Q_OBJECT

public:
  explicit Probe(QObject* parent = nullptr);

  /// Solves the point with these settings, then in `batches` independent batches of 32 trajectories.
  void start(const ScenePtr& scene, const Pick& pick, const MethodSettings& settings, int batches = 128);
  void cancel() { this->Queue.cancel(); }
  void forget();  ///< stops, and is as new
  bool active() const { return this->Queue.active(); }

  const std::optional<Pick>& pick() const { return this->Picked; }
  const std::optional<NearestEdge>& edge() const { return this->Edge; }
  std::optional<Estimate> estimate() const;
  qint64 trajectories() const;

  Chart convergence() const;  ///< estimate and 95 % interval against trajectories
  Chart histogram() const;    ///< of what single trajectories of the batches contribute, the largest marked

signals:
  void changed();
  void problem(const QString& message);

private:
  void take(int job);

  struct Step
  {
    qint64 trajectories;
    Estimate estimate;
  };
  RunQueue Queue;
  std::optional<Pick> Picked;
  std::optional<NearestEdge> Edge;
  std::optional<double> Truth;
  MethodSettings Settings;
  std::vector<Step> Steps;
  QVector<double> Contributions;  // of single trajectories, lx
};
}  // namespace studio

#endif
