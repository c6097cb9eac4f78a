// SPDX-License-Identifier: BSD-3-Clause
#include "Workbench.h"

namespace studio
{
void Workbench::open(const QString& path)
{
  const ScenePtr scene = SceneDocument::open(path);
  this->Current.reset();
  this->CurrentHasResult = false;
  this->Scene = scene;
  this->Chosen = scene->usualSets();
  this->Results.clear();
  this->ShownIndex = -1;
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
  if (!this->Scene || this->Chosen.isEmpty())
    return;
  this->Current = std::make_unique<Run>(this->Scene, this->Scene->receivers(this->Chosen), this->settings());
  this->CurrentHasResult = false;
  connect(this->Current.get(), &Run::refined, this, &Workbench::takeResult);
  connect(this->Current.get(), &Run::progressed, this, &Workbench::runChanged);
  connect(this->Current.get(), &Run::ended, this, [this] {
    emit this->runChanged();
    if (this->Current->state() == Run::State::Failed)
      emit this->problem(this->Current->problem());
  });
  emit this->runChanged();
}

void Workbench::cancel()
{
  if (this->isRunning())
    this->Current->cancel();
}

void Workbench::takeResult()
{
  if (!this->CurrentHasResult)
    this->Results << nullptr;
  this->CurrentHasResult = true;
  const bool follows = this->ShownIndex >= this->Results.size() - 2;
  this->Results.last() = this->Current->result();
  this->ShownIndex = follows ? static_cast<int>(this->Results.size()) - 1 : this->ShownIndex;
  emit this->resultsChanged();
}

void Workbench::addResult(const ResultPtr& result)
{
  const int before = static_cast<int>(this->Results.size()) - (this->CurrentHasResult ? 1 : 0);
  this->Results.insert(before, result);
  this->ShownIndex += this->ShownIndex >= before ? 1 : 0;
  this->show(this->ShownIndex < 0 ? before : this->ShownIndex);
}

void Workbench::show(int index)
{
  this->ShownIndex = index;
  emit this->resultsChanged();
}
}  // namespace studio
