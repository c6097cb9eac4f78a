// SPDX-License-Identifier: BSD-3-Clause
// Runs a plan in its own thread; the result is refined, and the run can be paused, resumed and cancelled.
#ifndef studio_Run_h
#define studio_Run_h

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "results/Result.h"
#include "run/RunPlan.h"

namespace studio
{
class Run : public QObject
{
  Q_OBJECT

public:
  enum class State
  {
    Running,
    Paused,
    Finished,   ///< its goal is reached, result() is complete
    Cancelled,  ///< result() is the last round's, or null
    Failed      ///< problem() says why
  };

  /// Starts at once. `settings` are those of the plan's last step.
  Run(RunPlan plan, const MethodSettings& settings, QObject* parent = nullptr);
  Run(const ScenePtr& scene, vtkDataObject* receivers, const MethodSettings& settings, bool previews = true)
      : Run(planReceivers(*scene, receivers, settings, previews), settings)
  {
  }
  ~Run() override;  ///< cancels, and waits for the thread

  const MethodSettings& settings() const { return this->Settings; }
  State state() const { return this->CurrentState; }
  bool active() const { return this->CurrentState == State::Running || this->CurrentState == State::Paused; }
  ResultPtr result() const { return this->Latest; }
  const QString& problem() const { return this->Problem; }
  double progress() const { return this->Progress; }  ///< of the last step, [0, 1]
  double elapsed() const;                             ///< s, pauses apart
  /// s until the goal, as far as the last step's progress tells; nothing at its very beginning and end.
  std::optional<double> remaining() const;

public slots:
  void pause();
  void resume();
  void cancel();

signals:
  /// result() is newer; with many receivers, rounds that come faster than the event loop takes them are left out.
  void refined();
  void progressed();  ///< at most four times a second
  void ended();       ///< state() is one of the last three

private:
  enum class Stage
  {
    Preview,
    Round,
    Last
  };
  void work();
  QString solve(const RunStep& step, bool last, const std::function<void(vtkDataObject*)>& round);
  bool waitWhilePaused();
  void publish(vtkDataObject* data, Stage stage);
  void setState(State state);

  MethodSettings Settings;
  RunPlan Plan;

  // Used by the owner's thread only.
  State CurrentState = State::Running;
  ResultPtr Latest;
  QString Problem;
  double Progress = 0;
  QElapsedTimer Clock;
  double ElapsedBefore = 0, LastStepBegan = 0;

  // Shared with the worker.
  std::atomic<bool> StopRequested{false};
  std::mutex Lock;  // guards PauseRequested and Pending
  std::condition_variable Wake;
  bool PauseRequested = false;
  ResultPtr Pending;
  std::thread Worker;
};
}  // namespace studio

#endif
