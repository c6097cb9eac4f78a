// SPDX-License-Identifier: BSD-3-Clause
#include "session/Workbench.h"

#include "base/Problem.h"
#include "scene/SceneDraft.h"

namespace studio
{
Workbench::Workbench(QObject* parent) : QObject(parent)
{
  this->Later.setSingleShot(true);
  connect(&this->Later, &QTimer::timeout, this, &Workbench::showResult);
}

void Workbench::open(const QString& path, bool turned)
{
  const ScenePtr scene = SceneDocument::open(path, turned);
  State state{this->settings(), this->display(), draftOf(path)};
  state.display.hidden.clear();
  this->SavedDraft = state.draft;
  this->History = UndoHistory<State>(state);
  this->ChosenSets = scene->usualSets();
  this->Required.clear();
  this->takeScene(scene);
  emit this->settingsChanged();
}

// Results of the scene before are dropped.
void Workbench::takeScene(const ScenePtr& scene)
{
  this->Current.reset();
  this->CurrentHasResult = false;
  this->Scene = scene;
  this->Series.clear();
  this->Results.clear();
  this->Tracks.clear();
  this->ShownIndex = -1;
  this->CurrentStudy.reset();
  this->Image.forget();
  this->Follows = true;
  this->Unsaved = false;
  this->Later.stop();
  emit this->runChanged();
  emit this->sceneChanged();
  emit this->resultsChanged();
}

void Workbench::edit(const QJsonObject& draft)
{
  if (draft == this->draft())
    return;
  const ScenePtr scene = SceneDocument::fromDraft(draft, this->Scene->path(), this->Scene->isTurned());
  State state = this->History.current();
  state.draft = draft;
  this->History.set(state);
  if (scene->sets() != this->Scene->sets())
    this->ChosenSets = scene->usualSets();
  this->takeScene(scene);
  emit this->settingsChanged();
}

void Workbench::saveScene(const QString& path)
{
  saveDraft(this->draft(), path);
  this->SavedDraft = this->draft();
}

void Workbench::setSettings(const MethodSettings& settings)
{
  if (settings == this->settings())
    return;
  State state = this->History.current();
  state.settings = settings;
  this->History.set(state);
  emit this->settingsChanged();
}

void Workbench::undo()
{
  const State before = this->History.current();
  this->History.undo();
  this->restore(before, false);
}

void Workbench::redo()
{
  const State before = this->History.current();
  this->History.redo();
  this->restore(before, true);
}

// The current state of the history in place of another one; where its scene cannot be opened any more, that one.
void Workbench::restore(const State& before, bool redone)
{
  const State& now = this->History.current();
  if (now.draft != before.draft)
  {
    try
    {
      const ScenePtr scene = SceneDocument::fromDraft(now.draft, this->Scene->path(), this->Scene->isTurned());
      this->ChosenSets = scene->usualSets();
      this->takeScene(scene);
    }
    catch (const Problem& problem)
    {
      redone ? this->History.undo() : this->History.redo();
      emit this->problem(problem.message());
    }
  }
  emit this->settingsChanged();
  if (this->display() != before.display)
    emit this->displayChanged();
}

void Workbench::setDisplay(const studio::Display& display)
{
  if (display == this->display())
    return;
  State state = this->History.current();
  state.display = display;
  this->History.set(state);
  emit this->settingsChanged();  // of what can be undone
  emit this->displayChanged();
}

void Workbench::setChosenSets(const QStringList& names)
{
  if (names == this->ChosenSets)
    return;
  this->ChosenSets = names;
  emit this->displayChanged();
}

void Workbench::setStudy(const std::optional<Study>& study)
{
  this->CurrentStudy = study;
  emit this->studyChanged();
}

void Workbench::require(const QString& set, const Requirement& requirement)
{
  this->Required[set] = requirement;
  emit this->requirementsChanged();
}

void Workbench::runStudy(const Study& study)
{
  this->setStudy(study);
  this->runSeries(study.series(*this->Scene, this->Results));
}

QVector<ResultPtr> Workbench::onOneScale() const
{
  QVector<ResultPtr> cells;
  if (this->CurrentStudy)
    cells = this->CurrentStudy->cells(this->Results);
  return cells.contains(this->shown()) ? cells : QVector<ResultPtr>{this->shown()};
}

void Workbench::addResult(const ResultPtr& result)
{
  const int before = static_cast<int>(this->Results.size()) - (this->CurrentHasResult ? 1 : 0);
  this->Results.insert(before, result);
  this->Tracks.insert(before, {QPointF(result->seconds, result->quality.typical)});
  this->ShownIndex += this->ShownIndex >= before ? 1 : 0;
  this->show(this->ShownIndex < 0 ? before : this->ShownIndex);
}

void Workbench::rename(int index, const QString& name)
{
  auto renamed = std::make_shared<Result>(*this->Results[index]);
  renamed->name = name;
  this->Results[index] = renamed;
  emit this->resultsChanged();
}

bool Workbench::canRemove(int index) const
{
  const bool refined = this->isRunning() && this->CurrentHasResult && index + 1 == this->Results.size();
  return this->Results.value(index) && !refined;
}

void Workbench::remove(int index)
{
  if (!this->canRemove(index))
    return;
  this->CurrentHasResult = this->CurrentHasResult && index + 1 < this->Results.size();
  this->Results.removeAt(index);
  this->Tracks.removeAt(index);
  const int last = static_cast<int>(this->Results.size()) - 1;
  this->show(std::min(this->ShownIndex > index ? this->ShownIndex - 1 : this->ShownIndex, last));
}

void Workbench::show(int index)
{
  this->ShownIndex = index;
  this->Follows = index + 1 == this->Results.size();
  emit this->resultsChanged();
}
}  // namespace studio
