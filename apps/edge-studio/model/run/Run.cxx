// SPDX-License-Identifier: BSD-3-Clause
#include "run/Run.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <algorithm>

#include "base/ErrorCollector.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
/// Lowers the priority of this thread below the window's. Threads that a solve starts
/// inherit it.
void yieldToTheWindow()
{
#ifdef __linux__
  const auto self = static_cast<id_t>(gettid());
  setpriority(PRIO_PROCESS, self, std::min(19, getpriority(PRIO_PROCESS, self) + 10));
#endif
}

/// Hands the data of an event to a handler, as long as this exists.
class Observation
{
public:
  template <class Handler>
  Observation(vtkObject* object, unsigned long event, Handler& handler) : Object(object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&handler);
    command->SetCallback(
        [](vtkObject*, unsigned long, void* client, void* data) { (*static_cast<Handler*>(client))(data); });
    this->Tag = object->AddObserver(event, command);
  }
  ~Observation() { this->Object->RemoveObserver(this->Tag); }
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;

private:
  vtkObject* Object;
  unsigned long Tag;
};
}  // namespace

Run::Run(RunPlan plan, const MethodSettings& settings, QObject* parent)
    : QObject(parent), Settings(settings), Plan(std::move(plan))
{
  this->Clock.start();
  this->Worker = std::thread([this] { this->work(); });
}

Run::~Run()
{
  this->cancel();
  this->Worker.join();
}

double Run::elapsed() const
{
  return this->ElapsedBefore +
         (this->CurrentState == State::Running ? static_cast<double>(this->Clock.elapsed()) / 1000 : 0);
}

std::optional<double> Run::remaining() const
{
  if (!(this->Progress > 0.02 && this->Progress < 1))
    return {};
  return (this->elapsed() - this->LastStepBegan) * (1 / this->Progress - 1);
}

void Run::setState(State state)
{
  this->ElapsedBefore = this->elapsed();
  this->Clock.restart();
  this->CurrentState = state;
}

void Run::pause()
{
  if (this->CurrentState != State::Running)
    return;
  this->setState(State::Paused);
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->PauseRequested = true;
}

void Run::resume()
{
  if (this->CurrentState != State::Paused)
    return;
  this->setState(State::Running);
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->PauseRequested = false;
  this->Wake.notify_all();
}

void Run::cancel()
{
  this->StopRequested = true;
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->PauseRequested = false;
  this->Wake.notify_all();
}

// The worker thread. It changes members of the owner only through events that the owner handles.

bool Run::waitWhilePaused()
{
  std::unique_lock<std::mutex> guard(this->Lock);
  this->Wake.wait(guard, [this] { return !this->PauseRequested; });
  return !this->StopRequested;
}

void Run::publish(vtkDataObject* data, Stage stage)
{
  auto result = std::make_shared<Result>(makeResult(this->Settings, data));
  result->complete = stage == Stage::Last;
  result->preview = stage == Stage::Preview;
  // With few receivers every round is published; with many only the newest one, so that the window does not lag behind.
  if (result->quality.receivers < 1000)
  {
    QMetaObject::invokeMethod(
        this,
        [this, result] {
          this->Latest = result;
          emit this->refined();
        },
        Qt::QueuedConnection);
    return;
  }
  bool announced;
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    announced = this->Pending != nullptr;
    this->Pending = result;
  }
  if (announced)
    return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        {
          const std::lock_guard<std::mutex> guard(this->Lock);
          this->Latest = std::move(this->Pending);
          this->Pending = nullptr;
        }
        emit this->refined();
      },
      Qt::QueuedConnection);
}

void Run::work()
{
  yieldToTheWindow();
  std::vector<RunStep> steps = this->Plan.steps();
  vtkSmartPointer<vtkDataObject> latest;
  QString problem;
  for (const RunStep& step : steps)
  {
    const bool last = &step == &steps.back();
    latest = nullptr;
    problem = this->solve(step, last, [&](vtkDataObject* data) {
      latest = step.makeOutput ? step.makeOutput(data) : vtkSmartPointer<vtkDataObject>(data);
      this->publish(latest, last ? Stage::Round : Stage::Preview);
    });
    if (!problem.isEmpty() || this->StopRequested)
      break;
  }
  steps.clear();
  this->Plan = {};  // the prepared scene is large
  const bool stopped = this->StopRequested;
  if (problem.isEmpty() && !stopped && latest)
    this->publish(latest, Stage::Last);
  QMetaObject::invokeMethod(
      this,
      [this, problem, stopped] {
        this->Problem = problem;
        this->setState(!problem.isEmpty() ? State::Failed : stopped ? State::Cancelled : State::Finished);
        this->Progress = this->CurrentState == State::Finished ? 1 : this->Progress;
        emit this->ended();
      },
      Qt::QueuedConnection);
}

QString Run::solve(const RunStep& step, bool last, const std::function<void(vtkDataObject*)>& round)
{
  vtkKalosEstimatorAlgorithm* estimator = this->Plan.estimator;
  const auto errors = ErrorCollector::watch(estimator);
  step.settings.apply(estimator);
  step.prepare();
  estimator->IntermediateResultsOn();
  estimator->KeepSceneOn();

  if (last)
    QMetaObject::invokeMethod(
        this, [this] { this->LastStepBegan = this->elapsed(); }, Qt::QueuedConnection);
  QElapsedTimer told;
  auto onProgress = [&](void*) {
    // With software OpenGL, 20 updates a second would take a third of a processor.
    if (last && (!told.isValid() || told.elapsed() > 250))
    {
      told.start();
      const double done = estimator->GetProgress();
      QMetaObject::invokeMethod(
          this,
          [this, done] {
            this->Progress = done;
            emit this->progressed();
          },
          Qt::QueuedConnection);
    }
    if (!this->waitWhilePaused())
      estimator->SetAbortExecute(1);
  };
  auto onRound = [&](void* data) { round(static_cast<vtkDataObject*>(data)); };
  const Observation progress(estimator, vtkCommand::ProgressEvent, onProgress),
      rounds(estimator, vtkCommand::UpdateDataEvent, onRound);
  if (!this->StopRequested)
    estimator->Update();
  return errors->message();
}
}  // namespace studio
