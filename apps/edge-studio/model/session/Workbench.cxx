// SPDX-License-Identifier: BSD-3-Clause
#include "session/Workbench.h"

namespace studio
{
void Workbench::open(const QString& path)
{
  const ScenePtr scene = SceneDocument::open(path);
  this->Current.reset();
  this->CurrentHasResult = false;
  this->Scene = scene;
  this->Chosen = scene->usualSets();
  this->Series.clear();
  this->Results.clear();
  this->Tracks.clear();
  this->ShownIndex = -1;
  this->Studied.reset();
  this->Seen.forget();
  emit this->runChanged();
  emit this->sceneChanged();
  emit this->resultsChanged();
}

void Workbench::setSettings(const MethodSettings& settings)
{
  if (settings == this->settings())
    return;
  this->History.set(settings);
  emit this->settingsChanged();
}

void Workbench::undo()
{
  this->History.undo();
  emit this->settingsChanged();
}

void Workbench::redo()
{
  this->History.redo();
  emit this->settingsChanged();
}

void Workbench::setDisplay(const studio::Display& display)
{
  if (display == this->Shown)
    return;
  this->Shown = display;
  emit this->displayChanged();
}

void Workbench::setChosenSets(const QStringList& names)
{
  if (names == this->Chosen)
    return;
  this->Chosen = names;
  emit this->displayChanged();
}

void Workbench::run()
{
  this->runSeries({this->settings()});
}

void Workbench::runSeries(const QVector<MethodSettings>& series)
{
  if (!this->Scene || this->Chosen.isEmpty())
    return;
  this->Series = series;
  this->runNext();
}

void Workbench::setStudy(const std::optional<Study>& study)
{
  this->Studied = study;
  emit this->studyChanged();
}

void Workbench::runStudy(const Study& study)
{
  this->setStudy(study);
  if (!this->Results.isEmpty())
    this->show(static_cast<int>(this->Results.size()) - 1);  // what is shown follows the newest result
  this->runSeries(study.series(*this->Scene, this->Results));
}

QVector<ResultPtr> Workbench::onOneScale() const
{
  QVector<ResultPtr> cells;
  if (this->Studied)
    cells = this->Studied->cells(this->Results);
  return cells.contains(this->shown()) ? cells : QVector<ResultPtr>{this->shown()};
}

void Workbench::runNext()
{
  if (this->Series.isEmpty())
    return;
  const MethodSettings settings = this->Series.takeFirst();
  this->Current = std::make_unique<Run>(this->Scene, this->Scene->receivers(this->Chosen), settings);
  this->CurrentHasResult = false;
  connect(this->Current.get(), &Run::refined, this, &Workbench::takeResult);
  // The run is replaced in what follows: not while it is still emitting.
  connect(
      this->Current.get(), &Run::ended, this,
      [this, run = this->Current.get()] {
        if (run != this->Current.get())
          return;  // another one was started meanwhile
        const Run::State state = run->state();
        if (state != Run::State::Finished)
          this->Series.clear();
        emit this->runChanged();
        emit this->runEnded();
        if (state == Run::State::Failed)
          emit this->problem(run->problem());
        this->runNext();
      },
      Qt::QueuedConnection);
  emit this->runBegan();
  emit this->runChanged();
}

void Workbench::cancel()
{
  this->Series.clear();
  if (this->isRunning())
    this->Current->cancel();
}

void Workbench::takeResult()
{
  if (!this->CurrentHasResult)
  {
    this->Results << nullptr;
    this->Tracks << QVector<QPointF>();
  }
  this->CurrentHasResult = true;
  const bool follows = this->ShownIndex >= this->Results.size() - 2;
  const ResultPtr result = this->Current->result();
  this->Results.last() = result;
  if (!result->preview && result->seconds > 0)
    this->Tracks.last() << QPointF(result->seconds, result->quality.typical);
  this->ShownIndex = follows ? static_cast<int>(this->Results.size()) - 1 : this->ShownIndex;
  emit this->resultsChanged();
}

void Workbench::addResult(const ResultPtr& result)
{
  const int before = static_cast<int>(this->Results.size()) - (this->CurrentHasResult ? 1 : 0);
  this->Results.insert(before, result);
  this->Tracks.insert(before, {QPointF(result->seconds, result->quality.typical)});
  this->ShownIndex += this->ShownIndex >= before ? 1 : 0;
  this->show(this->ShownIndex < 0 ? before : this->ShownIndex);
}

void Workbench::show(int index)
{
  this->ShownIndex = index;
  emit this->resultsChanged();
}
}  // namespace studio
