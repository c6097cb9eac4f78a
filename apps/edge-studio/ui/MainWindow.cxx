// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QStatusBar>
#include <QTabWidget>

#include "Colours.h"
#include "ComparePanel.h"
#include "Export.h"
#include "MethodPanel.h"
#include "ProbePanel.h"
#include "Problem.h"
#include "RecentFiles.h"
#include "Session.h"
#include "ShowPanel.h"
#include "SpeedPanel.h"
#include "StudyPanel.h"
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
  connect(&this->Bench, &Workbench::runBegan, this, &MainWindow::autosave);
  connect(&this->Bench, &Workbench::runEnded, this, &MainWindow::autosave);
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
  this->Compare = new ComparePanel(&this->Bench);
  tabs->addTab(this->Compare, tr("Compare"));
  tabs->addTab(new StudyPanel(&this->Bench, this->View), tr("Study"));
  tabs->addTab(new SpeedPanel(&this->Bench), tr("Speed"));
  tabs->setMinimumWidth(400);
  auto* side = new QDockWidget(tr("Analysis"));
  side->setObjectName(QStringLiteral("studyDock"));
  side->setWidget(tabs);
  side->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  this->addDockWidget(Qt::RightDockWidgetArea, side);

  connect(this->Compare, &ComparePanel::changed, this, &MainWindow::showResult);
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
  add(tr("&Save the session…"), QKeySequence::Save, [this] { this->saveSessionAs(); });
  file->addSeparator();
  QAction* picture = add(tr("Export the &picture…"), Qt::CTRL | Qt::Key_P, [this] { this->exportPictureAs(); });
  QAction* results = add(tr("Export the &values…"), Qt::CTRL | Qt::Key_E, [this] { this->exportResultsTo(); });
  auto enable = [this, picture, results] {
    picture->setEnabled(this->Bench.scene() != nullptr);
    results->setEnabled(this->Bench.shown() != nullptr);
  };
  connect(&this->Bench, &Workbench::resultsChanged, this, enable);
  enable();
  file->addSeparator();
  add(tr("&Quit"), QKeySequence::Quit, [this] { this->close(); });
}

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
      tr("Scenes and meshes (*.json *.glb *.gltf *.obj *.ply *.stl *.vtp);;All files (*)"));
  if (!path.isEmpty())
    this->openFile(path);
}

bool MainWindow::openFile(const QString& path)
{
  bool opened = false;
  this->attempt([&] {
    if (isSession(path))
    {
      if (const auto camera = openSession(this->Bench, path))
        this->View->look(*camera);
    }
    else
      this->Bench.open(path);
    addRecentFile(QFileInfo(path).absoluteFilePath());
    opened = true;
  });
  return opened;
}

void MainWindow::attempt(const std::function<void()>& action)
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
}

void MainWindow::saveSessionAs()
{
  const QString path = QFileDialog::getSaveFileName(this, tr("Save the session"), QString(), tr("Sessions (*.json)"));
  if (!path.isEmpty())
    this->attempt([&] { saveSession(this->Bench, this->View->camera(), path); });
}

void MainWindow::exportPictureAs()
{
  const QString path = QFileDialog::getSaveFileName(this, tr("Export the picture"), QString(), tr("PNG (*.png)"));
  if (!path.isEmpty() && !this->pictureWithLegend().save(path, "PNG"))
    this->complain(tr("%1: file: can not be written; expected a place that can be written").arg(path));
}

void MainWindow::exportResultsTo()
{
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Export the values, CSV and VTP, into a folder"));
  if (!folder.isEmpty())
    this->attempt([&] { exportResult(*this->Bench.shown(), folder); });
}

QImage MainWindow::pictureWithLegend()
{
  const QImage view = this->View->picture();
  if (!this->Bar->legend().colours)
    return view;
  const double ratio = view.devicePixelRatio();
  QImage image(view.width() + static_cast<int>(this->Bar->width() * ratio), view.height(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(QPointF(0, 0), view);
  drawLegend(painter, QRectF(view.width() / ratio, 0, this->Bar->width(), view.height() / ratio), this->Bar->legend(),
             Qt::black);
  return image;
}

void MainWindow::autosave()
{
  // Silent: what can not be saved here is no reason to disturb; an orderly end removes it.
  try
  {
    if (this->Bench.scene())
      saveSession(this->Bench, this->View->camera(), autosavePath());
  }
  catch (const Problem&)
  {
  }
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
  const ComparePanel::Mode mode = result ? this->Compare->mode() : ComparePanel::Mode::Off;
  const bool two = mode == ComparePanel::Mode::SideBySide || mode == ComparePanel::Mode::Swipe;
  Picture first, second;
  Legend legend;
  if (mode == ComparePanel::Mode::Difference)
  {
    first = {this->Compare->comparison().data, QString::fromLatin1(Comparison::arrayName), differenceColours(5), {}};
    legend = {first.colours, tr("Difference"), tr("std. errors"), {}};
  }
  else if (result)
  {
    const auto range = rangeOf({result, two ? this->Compare->other() : nullptr}, display);
    first = {result->data, QString::fromLatin1(arrayName(display.quantity)), falseColours(range, display.logarithmic),
             display.isolines ? roundValues(range, display.logarithmic, 10) : QVector<double>()};
    second = first;
    second.data = two ? this->Compare->other()->data : nullptr;
    legend = {first.colours, title(display.quantity), unitOf(display.quantity), QString()};
  }
  const auto layout = !two                                     ? SceneView::Layout::Single
                      : mode == ComparePanel::Mode::SideBySide ? SceneView::Layout::SideBySide
                                                               : SceneView::Layout::Swipe;
  if (layout != this->View->layoutMode())
    this->View->setLayoutMode(layout);
  this->View->paint(first, second, display);
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
  QFile::remove(autosavePath());
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
