// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QTabWidget>

#include "Colours.h"
#include "MethodPanel.h"
#include "ProbePanel.h"
#include "Problem.h"
#include "RecentFiles.h"
#include "ShowPanel.h"
#include "Wording.h"

namespace studio
{
MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent)
{
  this->setWindowTitle(tr("Edge Studio"));
  this->setAcceptDrops(true);
  this->resize(1360, 840);
  this->View = new SceneView;
  this->Bar = new LegendBar;
  auto* centre = new QWidget;
  auto* layout = new QHBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(this->View, 1);
  layout->addWidget(this->Bar);
  this->setCentralWidget(centre);
  this->makePanels();
  this->makeMenus();

  connect(&this->Bench, &Workbench::sceneChanged, this, &MainWindow::showScene);
  connect(&this->Bench, &Workbench::resultsChanged, this, &MainWindow::showResult);
  connect(&this->Bench, &Workbench::displayChanged, this, &MainWindow::showResult);
  connect(&this->Bench, &Workbench::displayChanged, this, &MainWindow::updatePicking);
  connect(&this->Bench, &Workbench::problem, this, &MainWindow::complain);
}

void MainWindow::makePanels()
{
  auto dock = [this](const QString& title, const QString& name, QWidget* panel) {
    auto* made = new QDockWidget(title);
    made->setObjectName(name);
    made->setWidget(panel);
    panel->setMaximumWidth(290);
    made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    this->addDockWidget(Qt::LeftDockWidgetArea, made);
    return made;
  };
  dock(tr("Method"), QStringLiteral("methodDock"), new MethodPanel(&this->Bench));
  dock(tr("Show"), QStringLiteral("showDock"), new ShowPanel(&this->Bench));

  auto* probe = new ProbePanel(&this->Bench);
  auto* line = new LinePanel(&this->Bench);
  auto* tabs = new QTabWidget;
  tabs->setObjectName(QStringLiteral("tabs"));
  tabs->setDocumentMode(true);
  tabs->addTab(probe, tr("Probe"));
  tabs->addTab(line, tr("Across an edge"));
  tabs->setMinimumWidth(380);
  auto* side = new QDockWidget(tr("Study"));
  side->setObjectName(QStringLiteral("studyDock"));
  side->setWidget(tabs);
  side->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  this->addDockWidget(Qt::RightDockWidgetArea, side);

  connect(this->View, &SceneView::picked, probe, &ProbePanel::probe);
  connect(this->View, &SceneView::picked, line, &LinePanel::aim);
  connect(probe, &ProbePanel::marked, this, [this](const auto& lines) { this->mark(0, lines); });
  connect(line, &LinePanel::marked, this, [this](const auto& lines) { this->mark(1, lines); });
}

void MainWindow::mark(int kind, const QVector<QVector<Point>>& lines)
{
  this->Marks[kind] = lines;
  this->View->mark(this->Marks[0] + this->Marks[1]);
}

void MainWindow::makeMenus()
{
  auto add = [this](QMenu* menu, const QString& text, const QKeySequence& keys, auto handler) {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, handler);
    return action;
  };
  QMenu* file = this->menuBar()->addMenu(tr("&File"));
  add(file, tr("&Open…"), QKeySequence::Open, [this] { this->chooseFile(); });
  this->RecentMenu = file->addMenu(tr("Open &recent"));
  connect(this->RecentMenu, &QMenu::aboutToShow, this, &MainWindow::listRecent);
  file->addSeparator();
  add(file, tr("&Quit"), QKeySequence::Quit, [this] { this->close(); });

  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  QAction* undo = add(edit, tr("&Undo setting"), QKeySequence::Undo, [this] { this->Bench.undo(); });
  QAction* redo = add(edit, tr("&Redo setting"), QKeySequence::Redo, [this] { this->Bench.redo(); });
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
  auto enableRun = [this, start, pause, cancel] {
    start->setEnabled(this->Bench.scene() && !this->Bench.isRunning());
    pause->setEnabled(this->Bench.isRunning());
    cancel->setEnabled(this->Bench.isRunning());
  };
  connect(&this->Bench, &Workbench::runChanged, this, enableRun);
  connect(&this->Bench, &Workbench::sceneChanged, this, enableRun);
  enableRun();

  this->CameraMenu = this->menuBar()->addMenu(tr("&Camera"));
}

void MainWindow::chooseFile()
{
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a scene"), this->Bench.scene() ? this->Bench.scene()->path() : QString(),
      tr("Scenes and meshes (*.json *.obj *.ply *.stl *.vtp);;All files (*)"));
  if (!path.isEmpty())
    this->openFile(path);
}

bool MainWindow::openFile(const QString& path)
{
  QApplication::setOverrideCursor(Qt::WaitCursor);
  QString trouble;
  try
  {
    this->Bench.open(path);
    addRecentFile(this->Bench.scene()->path());
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

void MainWindow::complain(const QString& message)
{
  // FILE: WHERE: what is wrong and what is expected
  const QStringList parts = message.split(QStringLiteral(": "));
  QMessageBox box(QMessageBox::Warning, tr("Edge Studio"), QString(), QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("problem"));
  if (parts.size() >= 3)
  {
    box.setText(tr("%1 can not be used.").arg(parts[0]));
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

void MainWindow::updatePicking()
{
  QStringList sets = this->Bench.scene()->sets();
  for (const QString& name : this->Bench.display().hidden)
    sets.removeAll(name);
  this->View->setPicking(std::make_shared<Picking>(this->Bench.scene(), sets));
}

void MainWindow::showScene()
{
  const ScenePtr& scene = this->Bench.scene();
  this->setWindowTitle(tr("%1 – Edge Studio").arg(scene->name()));
  this->Marks = {};
  this->View->setScene(scene);
  this->listCameras();
  this->updatePicking();
  this->showResult();
  QString about = tr("%1 polygons, %2 luminaires")
                      .arg(scene->surfaces()->GetNumberOfCells())
                      .arg(scene->luminaires()->GetNumberOfPoints());
  if (scene->isBareMesh())
    about = tr("A mesh without light: reflectance 0.5 and 100 lm/m² everywhere");
  if (const auto lux = scene->furnaceIlluminance())
    about += tr(" · a white furnace, %1 lx everywhere").arg(*lux);
  this->statusBar()->showMessage(about);
}

void MainWindow::showResult()
{
  const ResultPtr result = this->Bench.shown();
  const Display& display = this->Bench.display();
  Picture picture;
  Legend legend;
  if (result)
  {
    const auto range = rangeOf({result}, display);
    picture = {result->data, QString::fromLatin1(arrayName(display.quantity)), falseColours(range, display.logarithmic),
               display.isolines ? roundValues(range, display.logarithmic, 10) : QVector<double>()};
    legend = {picture.colours, title(display.quantity), unitOf(display.quantity), QString()};
  }
  this->View->paint(picture, {}, display);
  this->Bar->setLegend(legend);
  this->Bar->setVisible(result != nullptr);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (this->Bench.isRunning())
  {
    QMessageBox box(QMessageBox::Question, tr("Edge Studio"), tr("A run is under way. Stop it and close?"),
                    QMessageBox::Yes | QMessageBox::No, this);
    box.setObjectName(QStringLiteral("closing"));
    if (box.exec() != QMessageBox::Yes)
      return event->ignore();
    this->Bench.cancel();
  }
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
