// SPDX-License-Identifier: BSD-3-Clause
// All menus of the window except File.
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>

#include "session/Preferences.h"
#include "window/MainWindow.h"

namespace studio
{
void MainWindow::makeMenus()
{
  auto add = [this](QMenu* menu, const QString& text, const QKeySequence& keys, auto handler) {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, handler);
    return action;
  };
  this->makeFileMenu();
  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  QAction* undo = add(edit, tr("&Undo"), QKeySequence::Undo, [this] { this->Bench.undo(); });
  QAction* redo = add(edit, tr("&Redo"), QKeySequence::Redo, [this] { this->Bench.redo(); });
  undo->setObjectName(QStringLiteral("undo"));
  auto enable = [this, undo, redo] {
    undo->setEnabled(this->Bench.canUndo());
    redo->setEnabled(this->Bench.canRedo());
  };
  connect(&this->Bench, &Workbench::settingsChanged, this, enable);
  enable();

  QMenu* run = this->menuBar()->addMenu(tr("&Run"));
  QAction* start = add(run, tr("&Run"), Qt::Key_F5, [this] { this->Bench.run(); });
  QAction* pause = add(run, tr("&Pause or continue"), Qt::Key_F6, [this] {
    Run* current = this->Bench.activeRun();
    current->state() == Run::State::Paused ? current->resume() : current->pause();
    emit this->Bench.runChanged();
  });
  QAction* cancel = add(run, tr("&Cancel"), Qt::Key_Escape, [this] { this->Bench.cancel(); });
  run->addSeparator();
  QAction* light = run->addAction(tr("&Light a scene when it is opened"));
  light->setObjectName(QStringLiteral("light"));
  light->setCheckable(true);
  light->setChecked(lightsOnOpening());
  connect(light, &QAction::toggled, this, &setLightsOnOpening);
  auto enableRun = [this, start, pause, cancel] {
    start->setEnabled(this->Bench.scene() && !this->Bench.isBusy());
    pause->setEnabled(this->Bench.isRunning());
    cancel->setEnabled(this->Bench.isRunning());
  };
  connect(&this->Bench, &Workbench::runChanged, this, enableRun);
  connect(&this->Bench, &Workbench::sceneChanged, this, enableRun);
  enableRun();

  this->CameraMenu = this->menuBar()->addMenu(tr("&Camera"));
  QMenu* view = this->menuBar()->addMenu(tr("&View"));
  for (auto* dock : this->findChildren<QDockWidget*>())
    view->addAction(dock->toggleViewAction());
  QMenu* help = this->menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Keys and mouse…"), QKeySequence::HelpContents, [this] { this->explainKeys(); });
  add(help, tr("&About Edge Studio…"), {}, [this] {
    QMessageBox::about(this, tr("About Edge Studio"),
                       tr("Edge Studio %1 shows the illuminance and luminance of a scene, and what each method does at "
                          "its edges. It is a part of Kalos.")
                           .arg(QCoreApplication::applicationVersion()));
  });
}

void MainWindow::explainKeys()
{
  QMessageBox box(QMessageBox::Information, tr("Keys and mouse"), tr("In the scene"), QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("keys"));
  box.setInformativeText(
      tr("Drag: turn. Wheel: nearer and farther. Drag with the middle button: move.\n"
         "Arrows: turn. Plus and minus: nearer and farther.\n"
         "Click: probe the point.\n\n"
         "In a chart, click a name to hide its curve, turn the wheel to zoom, double-click to see all."));
  box.exec();
}

void MainWindow::listCameras()
{
  this->CameraMenu->clear();
  int key = Qt::Key_1;
  auto add = [&](const QString& name, auto handler) {
    QAction* action = this->CameraMenu->addAction(name);
    action->setShortcut(Qt::CTRL | key++);
    connect(action, &QAction::triggered, this, handler);
  };
  for (const CameraPreset& camera : this->Bench.scene()->cameras())
    if (key <= Qt::Key_4)
      add(camera.name, [this, camera] { this->View->look(camera); });
  this->CameraMenu->addSeparator();
  add(tr("Oblique"), [this] { this->View->lookAlong({0.35, 0.8, -0.45}, {0, 0, 1}); });
  add(tr("From above"), [this] { this->View->lookAlong({0, 0, -1}, {0, 1, 0}); });
  add(tr("From the front"), [this] { this->View->lookAlong({0, 1, 0}, {0, 0, 1}); });
  add(tr("From the left"), [this] { this->View->lookAlong({1, 0, 0}, {0, 0, 1}); });
}
}  // namespace studio
