// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include "ErrorCollector.h"
#include "Preview.h"
#include "vtkCallbackCommand.h"
#include "vtkKalosIlluminance.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
/// Leaves the processors to the window when both want them. Threads that a solve starts inherit it.
void yieldToTheWindow()
{
#ifdef __linux__
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10);
#endif
}

template <class Data>
vtkSmartPointer<Data> copyOf(Data* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

template <class Handler>
vtkSmartPointer<vtkCallbackCommand> observe(vtkObject* object, unsigned long event, Handler& handler)
{
  auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&handler);
  command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* data) { (*static_cast<Handler*>(client))(data); });
  object->AddObserver(event, command);
  return command;
}
}  // namespace

Run::Run(const ScenePtr& scene, vtkDataObject* receivers, const MethodSettings& settings, QObject* parent)
    : QObject(parent),
      Wanted(settings),
      Receivers(copyOf(receivers)),
      Surfaces(copyOf(scene->surfaces())),
      Luminaires(copyOf(scene->luminaires()))
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
  return this->ElapsedBefore + (this->Now == State::Running ? static_cast<double>(this->Clock.elapsed()) / 1000 : 0);
}

void Run::setState(State state)
{
  this->ElapsedBefore = this->elapsed();
  this->Clock.restart();
  this->Now = state;
}

void Run::pause()
{
  if (this->Now != State::Running)
    return;
  this->setState(State::Paused);
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->Resting = true;
}

void Run::resume()
{
  if (this->Now != State::Paused)
    return;
  this->setState(State::Running);
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->Resting = false;
  this->Wake.notify_all();
}

void Run::cancel()
{
  this->Stop = true;
  const std::lock_guard<std::mutex> guard(this->Lock);
  this->Resting = false;
  this->Wake.notify_all();
}

// Below: the worker, which touches the owner's members only by events that the owner handles.

bool Run::restIfAsked()
{
  std::unique_lock<std::mutex> guard(this->Lock);
  this->Wake.wait(guard, [this] { return !this->Resting; });
  return !this->Stop;
}

void Run::publish(vtkDataObject* data, Stage stage)
{
  auto result = std::make_shared<Result>(makeResult(this->Wanted, data));
  result->complete = stage == Stage::Last;
  result->preview = stage == Stage::Preview;
  // Of few receivers every round is told, of many the newest: the window shall not lag behind.
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
  // First colours at once; where there are very many receivers, better ones before the first full round too.
  for (const auto& [receivers, trajectories] : {std::pair{1200, 32}, std::pair{15000, 256}})
    if (const auto some = someReceivers(this->Receivers, receivers))
    {
      MethodSettings first = this->Wanted;
      first.goal = Goal::Trajectories;
      first.trajectories = trajectories;
      const QString problem = this->solve(
          some, first, [&](vtkDataObject* data) { this->publish(spread(data, this->Receivers), Stage::Preview); });
      if (!problem.isEmpty())
        break;  // the whole run will meet it again
    }
  vtkSmartPointer<vtkDataObject> latest;
  const QString problem = this->solve(this->Receivers, this->Wanted, [&](vtkDataObject* data) {
    latest = data;
    this->publish(data, Stage::Round);
  });
  const bool stopped = this->Stop;
  if (problem.isEmpty() && !stopped && latest)
    this->publish(latest, Stage::Last);
  QMetaObject::invokeMethod(
      this,
      [this, problem, stopped] {
        this->Problem = problem;
        this->setState(!problem.isEmpty() ? State::Failed : stopped ? State::Cancelled : State::Finished);
        this->Done = this->Now == State::Finished ? 1 : this->Done;
        emit this->ended();
      },
      Qt::QueuedConnection);
}

QString Run::solve(vtkDataObject* receivers, const MethodSettings& settings,
                   const std::function<void(vtkDataObject*)>& round)
{
  vtkNew<vtkKalosIlluminance> illuminance;
  const auto errors = ErrorCollector::watch(illuminance);
  settings.apply(illuminance);
  illuminance->SetInputDataObject(0, receivers);
  illuminance->SetInputData(1, this->Surfaces);
  illuminance->SetInputData(2, this->Luminaires);
  illuminance->IntermediateResultsOn();

  auto onProgress = [&](void*) {
    const double done = illuminance->GetProgress();
    QMetaObject::invokeMethod(
        this,
        [this, done] {
          this->Done = done;
          emit this->progressed();
        },
        Qt::QueuedConnection);
    if (!this->restIfAsked())
      illuminance->SetAbortExecute(1);
  };
  auto onRound = [&](void* data) { round(static_cast<vtkDataObject*>(data)); };
  const auto progress = observe(illuminance, vtkCommand::ProgressEvent, onProgress);
  const auto rounds = observe(illuminance, vtkCommand::UpdateDataEvent, onRound);
  if (!this->Stop)
    illuminance->Update();
  return errors->message();
}
}  // namespace studio
