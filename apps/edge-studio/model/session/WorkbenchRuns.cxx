// SPDX-License-Identifier: BSD-3-Clause
// The runs of the workbench, one after the other.
#include "base/DataSets.h"
#include "session/Workbench.h"
#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
namespace
{
/// The fast method for a second, whatever the scene.
MethodSettings firstLight()
{
  MethodSettings settings;
  settings.method = vtkKalosEstimatorAlgorithm::GATHERED;
  settings.goal = Goal::Time;
  settings.seconds = 1;
  return settings;
}
}  // namespace

void Workbench::run()
{
  this->runSeries({this->settings()});
}

void Workbench::runSeries(const QVector<MethodSettings>& series)
{
  if (!this->Scene)
    return;
  if (this->ChosenSets.isEmpty())
  {
    emit this->problem(tr("There is nothing to compute. Tick a set of points in the column Compute."));
    return;
  }
  this->start(series, true);
}

void Workbench::runUnasked()
{
  if (this->Scene && !this->ChosenSets.isEmpty())
    this->start({firstLight(), this->settings()}, false);
}

void Workbench::start(const QVector<MethodSettings>& series, bool asked)
{
  this->Asked = asked;
  this->Follows = true;
  this->Series = series;
  this->runNext();
}

bool Workbench::showsAll() const
{
  const ResultPtr result = this->shown();
  QStringList missing = this->ChosenSets;
  for (const NamedSet& set : dataSets(result ? result->data.Get() : nullptr))
    missing.removeAll(set.name);
  return missing.isEmpty();
}

void Workbench::runNext()
{
  if (this->Series.isEmpty())
    return;
  const MethodSettings settings = this->Series.takeFirst();
  // A preview is not needed where a complete picture is shown already.
  this->Current =
      std::make_unique<Run>(this->Scene, this->Scene->receivers(this->ChosenSets), settings, !this->showsAll());
  this->CurrentHasResult = false;
  connect(this->Current.get(), &Run::refined, this, &Workbench::takeResult);
  // The handler replaces the run, so it must not be called while the run is still emitting.
  connect(
      this->Current.get(), &Run::ended, this,
      [this, run = this->Current.get()] {
        if (run == this->Current.get())  // else another one was started meanwhile
          this->endRun();
      },
      Qt::QueuedConnection);
  emit this->runBegan();
  emit this->runChanged();
}

void Workbench::endRun()
{
  const Run::State state = this->Current->state();
  const QString trouble = this->Current->problem();
  if (state != Run::State::Finished)
    this->Series.clear();
  if (this->Later.isActive())
    this->showResult();
  emit this->runChanged();
  emit this->runEnded();
  if (state == Run::State::Failed)
    emit this->problem(trouble);
  this->runNext();
}

void Workbench::cancel()
{
  this->Series.clear();
  if (this->isRunning())
    this->Current->cancel();
}

void Workbench::takeResult()
{
  const bool first = !this->CurrentHasResult;
  if (first)
  {
    this->Results << nullptr;
    this->Tracks << QVector<QPointF>();
  }
  this->CurrentHasResult = true;
  const ResultPtr result = this->Current->result();
  this->Results.last() = result;
  this->Unsaved = this->Unsaved || this->Asked;
  if (!result->preview && result->seconds > 0)
    this->Tracks.last() << QPointF(result->seconds, result->quality.typical);
  const int wait = first || result->complete ? 0 : this->Budget.wait();
  if (wait == 0)
    this->showResult();
  else if (!this->Later.isActive())
    this->Later.start(wait);
}

void Workbench::showResult()
{
  this->Later.stop();
  if (this->Follows)
    this->ShownIndex = static_cast<int>(this->Results.size()) - 1;
  this->Budget.redrawn();
  emit this->resultsChanged();
}
}  // namespace studio
