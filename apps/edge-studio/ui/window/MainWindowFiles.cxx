// SPDX-License-Identifier: BSD-3-Clause
// Opens and saves scenes and sessions, and asks before results are lost.
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <algorithm>

#include "base/Problem.h"
#include "common/SaveDialog.h"
#include "common/UnitDialog.h"
#include "panels/ImagePanel.h"
#include "session/Preferences.h"
#include "session/Session.h"
#include "window/Application.h"
#include "window/MainWindow.h"

namespace studio
{
void MainWindow::makeFileMenu()
{
  QMenu* file = this->menuBar()->addMenu(tr("&File"));
  auto add = [this, file](const QString& text, const QKeySequence& keys, auto handler) {
    QAction* action = file->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, handler);
    return action;
  };
  add(tr("&Open…"), QKeySequence::Open, [this] { this->chooseFile(); });
  this->RecentMenu = file->addMenu(tr("Open &recent"));
  connect(this->RecentMenu, &QMenu::aboutToShow, this, &MainWindow::listRecent);
  QAction* last = add(tr("Reopen the &last session"), {}, [this] { this->openFile(lastSessionPath()); });
  connect(file, &QMenu::aboutToShow, this, [last] { last->setEnabled(QFileInfo(lastSessionPath()).isFile()); });
  add(tr("&Save the session…"), QKeySequence::Save, [this] { this->saveSessionAs(); });
  QAction* scene = add(tr("Save the s&cene…"), QKeySequence::SaveAs, [this] { this->saveSceneAs(); });
  QAction* again = add(tr("Re&load the scene"), QKeySequence::Refresh, [this] { this->reload(); });
  again->setObjectName(QStringLiteral("reload"));
  file->addSeparator();
  QAction* picture = add(tr("Export the &picture…"), Qt::CTRL | Qt::Key_P, [this] { this->exportPictureAs(); });
  QAction* image =
      add(tr("Export the &image as EXR…"), Qt::CTRL | Qt::SHIFT | Qt::Key_E, [this] { this->exportImageAs(); });
  image->setObjectName(QStringLiteral("exportImage"));
  QAction* results = add(tr("Export the &values…"), Qt::CTRL | Qt::Key_E, [this] { this->exportResultsTo(); });
  auto enable = [this, scene, again, picture, image, results] {
    scene->setEnabled(this->Bench.scene() != nullptr);
    again->setEnabled(this->Bench.scene() != nullptr);
    image->setEnabled(this->Bench.image().result() != nullptr);
    picture->setEnabled(this->Bench.scene() != nullptr);
    results->setEnabled(this->Bench.shown() != nullptr);
  };
  connect(&this->Bench, &Workbench::resultsChanged, this, enable);
  connect(this->Image, &ImagePanel::changed, this, enable);
  enable();
  file->addSeparator();
  add(tr("&Quit"), QKeySequence::Quit, [this] { this->close(); });
}

void MainWindow::chooseFile()
{
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a scene"), this->Bench.scene() ? this->Bench.scene()->path() : QString(),
      tr("Scenes and meshes (*.json *.gltf *.glb *.obj *.ply *.stl *.vtp);;All files (*)"));
  if (!path.isEmpty())
    this->openFile(path);
}

bool MainWindow::openFile(const QString& path)
{
  if (!this->mayDropResults())
    return false;
  const bool session = isSession(path);
  const bool opened = this->attempt([&] {
    if (session)
      this->View->look(openSession(this->Bench, path));
    else
      this->Bench.open(path);
    if (path != autosavePath() && path != lastSessionPath())
      addRecentFile(QFileInfo(path).absoluteFilePath());
  });
  if (!opened || session)
    return opened;
  if (this->Bench.scene()->facesOutward() && this->offerTurning())
    this->attempt([&] { this->Bench.open(path, true); });
  this->offerUnits();
  if (lightsOnOpening())
    this->Bench.runUnasked();
  return true;
}

void MainWindow::openFirst(const QString& path)
{
  if (path.isEmpty() || !this->openFile(path))
    this->openFile(demoScene());
}

bool MainWindow::attempt(const std::function<void()>& action)
{
  QApplication::setOverrideCursor(Qt::WaitCursor);
  QString trouble;
  try
  {
    action();
  }
  catch (const Problem& problem)
  {
    trouble = problem.message();
  }
  QApplication::restoreOverrideCursor();
  if (!trouble.isEmpty())
    this->complain(trouble);
  return trouble.isEmpty();
}

bool MainWindow::saveSessionAs()
{
  const QString path = askSavePath(this, tr("Save the session"), {{tr("Session"), sessionSuffix}});
  return !path.isEmpty() && this->attempt([&] {
    saveSession(this->Bench, this->View->camera(), path);
    this->Bench.markSaved();
  });
}

// Of a model or a bare mesh that is hardly a room or a building in metres.
void MainWindow::offerUnits()
{
  const ScenePtr scene = this->Bench.scene();
  if (scene->path().endsWith(QLatin1String(".json"), Qt::CaseInsensitive) || !isImplausible(scene->size()))
    return;
  UnitDialog dialog(scene->size(), this);
  if (dialog.exec() == QDialog::Accepted)
    this->attempt([&] { this->Bench.edit(dialog.applied(this->Bench.draft())); });
  this->View->lookAlong({0.35, 0.8, -0.45}, {0, 0, 1});
}

void MainWindow::editScene(const QJsonObject& draft)
{
  if (this->Bench.hasUnsavedResults() && !this->mayDropResults())
    return;
  if (this->attempt([&] { this->Bench.edit(draft); }) && lightsOnOpening())
    this->Bench.runUnasked();
}

bool MainWindow::saveSceneAs()
{
  const QString path = askSavePath(this, tr("Save the scene"), {{tr("Scene"), QStringLiteral("json")}});
  return !path.isEmpty() && this->attempt([&] { this->Bench.saveScene(path); });
}

void MainWindow::reload()
{
  if (!this->mayDropResults())
    return;
  const QString path = this->Bench.scene()->path();
  const bool turned = this->Bench.scene()->isTurned();
  if (this->attempt([&] { this->Bench.open(path, turned); }) && lightsOnOpening())
    this->Bench.runUnasked();
}

void MainWindow::watchFile()
{
  if (!this->Watcher.files().isEmpty())
    this->Watcher.removePaths(this->Watcher.files());
  this->Watcher.addPath(this->Bench.scene()->path());
}

bool MainWindow::mayDropResults()
{
  if (!this->Bench.unsaved())
    return true;
  const QString name = this->Bench.scene()->name();
  QMessageBox box(QMessageBox::Question, tr("Edge Studio"),
                  this->Bench.hasUnsavedResults() ? tr("The results of %1 are not saved.").arg(name)
                                                  : tr("The changes of %1 are not saved.").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName(QStringLiteral("dropping"));
  box.setInformativeText(tr("Another scene takes their place, and a run ends."));
  const int chosen = box.exec();
  return chosen == QMessageBox::Discard || (chosen == QMessageBox::Save && this->saveSessionAs());
}

bool MainWindow::offerTurning()
{
  QMessageBox box(QMessageBox::Question, tr("Edge Studio"), tr("The fronts of this mesh are outside."),
                  QMessageBox::Yes | QMessageBox::No, this);
  box.setObjectName(QStringLiteral("turning"));
  box.setInformativeText(tr("It lights the space around it, and its inside stays dark. Turn its faces inside?"));
  return box.exec() == QMessageBox::Yes;
}

void MainWindow::saveQuietly(const QString& path)
{
  // A failed automatic save does not interrupt the user.
  try
  {
    if (this->Bench.scene())
      saveSession(this->Bench, this->View->camera(), path);
  }
  catch (const Problem&)
  {
  }
}

void MainWindow::autosave()
{
  this->saveQuietly(autosavePath());
}

void MainWindow::offerAutosave()
{
  if (!QFileInfo(autosavePath()).isFile())
    return;
  QMessageBox box(QMessageBox::Question, tr("Edge Studio"),
                  tr("The last session did not end in an orderly way. Open what was saved of it?"),
                  QMessageBox::Yes | QMessageBox::No, this);
  if (box.exec() == QMessageBox::Yes)
    this->openFile(autosavePath());
}

void MainWindow::complain(const QString& message)
{
  // FILE: WHERE: what is wrong and what is expected
  const QStringList parts = message.split(QStringLiteral(": "));
  QMessageBox box(QMessageBox::Warning, tr("Edge Studio"), QString(), QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("problem"));
  if (parts.size() >= 3)
  {
    box.setText(tr("%1 cannot be used.").arg(parts[0]));
    box.setInformativeText(
        tr("Where: %1\n\nWhat: %2").arg(parts[1], QStringList(parts.mid(2)).join(QStringLiteral(": "))));
  }
  else
    box.setText(message);
  box.exec();
}

void MainWindow::listRecent()
{
  this->RecentMenu->clear();
  for (const QString& path : recentFiles())
    connect(this->RecentMenu->addAction(path), &QAction::triggered, this, [this, path] { this->openFile(path); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (this->Bench.isBusy() || this->Bench.image().active())
  {
    QMessageBox box(QMessageBox::Question, tr("Edge Studio"), tr("A run is under way. Stop it and close?"),
                    QMessageBox::Yes | QMessageBox::No, this);
    box.setObjectName(QStringLiteral("closing"));
    if (box.exec() != QMessageBox::Yes)
      return event->ignore();
  }
  this->Bench.cancel();
  this->Bench.image().cancel();
  const QVector<ResultPtr>& results = this->Bench.results();
  if (this->Bench.isEdited() ||
      std::any_of(results.begin(), results.end(), [](const ResultPtr& result) { return result && !result->preview; }))
    this->saveQuietly(lastSessionPath());
  removeSession(autosavePath());
  setWindowLayout(this->saveState());
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
  event->acceptProposedAction();
  this->openFile(event->mimeData()->urls().front().toLocalFile());
}
}  // namespace studio
