// SPDX-License-Identifier: BSD-3-Clause
#include "window/MainWindow.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QStatusBar>
#include <QTabWidget>

#include "common/Wording.h"
#include "panels/ComparePanel.h"
#include "panels/EditPanel.h"
#include "panels/ImagePanel.h"
#include "panels/LensPanel.h"
#include "panels/MethodPanel.h"
#include "panels/ProbePanel.h"
#include "panels/ShowPanel.h"
#include "panels/SpeedPanel.h"
#include "panels/StudyPanel.h"
#include "panels/ValuesPanel.h"
#include "results/Colours.h"
#include "session/Preferences.h"
#include "view/Marks.h"
#include "view/Pictures.h"

namespace studio
{
MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent)
{
  this->setWindowTitle(tr("Edge Studio"));
  this->setAcceptDrops(true);
  this->resize(1360, 840);
  this->View = new SceneView;
  this->Bar = new LegendBar;
  this->Bar->setObjectName(QStringLiteral("legend"));
  this->Image = new ImagePanel(&this->Bench, this->View);
  this->Centre = new QTabWidget;
  this->Centre->setObjectName(QStringLiteral("centre"));
  this->Centre->setDocumentMode(true);
  this->Centre->addTab(this->View, tr("Scene"));
  this->Centre->addTab(this->Image, tr("Image"));
  auto* centre = new QWidget;
  auto* layout = new QHBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(this->Centre, 1);
  layout->addWidget(this->Bar);
  this->setCentralWidget(centre);
  this->makePanels();
  this->makeMenus();
  this->restoreState(windowLayout());

  connect(&this->Bench, &Workbench::sceneChanged, this, &MainWindow::showScene);
  connect(&this->Bench, &Workbench::resultsChanged, this, &MainWindow::showResult);
  connect(&this->Bench, &Workbench::displayChanged, this, &MainWindow::showResult);
  connect(&this->Bench, &Workbench::displayChanged, this, &MainWindow::updatePicking);
  connect(this->Image, &ImagePanel::changed, this, &MainWindow::showLegend);
  connect(this->Image, &ImagePanel::saveAsked, this, &MainWindow::exportImageAs);
  connect(this->Centre, &QTabWidget::currentChanged, this, &MainWindow::showLegend);
  connect(&this->Watcher, &QFileSystemWatcher::fileChanged, this, [this] {
    this->statusBar()->showMessage(
        tr("%1 has changed on disk: File > Reload the scene reads it again.").arg(this->Bench.scene()->name()));
  });
  connect(&this->Bench, &Workbench::problem, this, &MainWindow::complain);
  connect(&this->Bench, &Workbench::runBegan, this, &MainWindow::autosave);
  connect(&this->Bench, &Workbench::runEnded, this, &MainWindow::autosave);
  connect(&this->Bench.image(), &CameraImage::ended, this, &MainWindow::autosave);
}

void MainWindow::makePanels()
{
  auto dock = [this](const QString& title, const QString& name, QWidget* panel) {
    auto* made = new QDockWidget(title);
    made->setObjectName(name);
    made->setWidget(panel);
    panel->setMaximumWidth(290);
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
  tabs->addTab(line, tr("Line"));
  auto* lens = new LensPanel(&this->Bench, this->View);
  this->Compare = new ComparePanel(&this->Bench);
  tabs->addTab(this->Compare, tr("Compare"));
  tabs->addTab(new StudyPanel(&this->Bench, this->View), tr("Study"));
  tabs->addTab(new SpeedPanel(&this->Bench), tr("Speed"));
  tabs->addTab(lens, tr("Lens"));
  auto* values = new ValuesPanel(&this->Bench);
  tabs->addTab(values, tr("Values"));
  auto* edit = new EditPanel(&this->Bench);
  tabs->addTab(edit, tr("Edit"));
  tabs->setMinimumWidth(400);
  auto* side = new QDockWidget(tr("Analysis"));
  side->setObjectName(QStringLiteral("studyDock"));
  side->setWidget(tabs);
  this->addDockWidget(Qt::RightDockWidgetArea, side);

  connect(this->Compare, &ComparePanel::changed, this, &MainWindow::showResult);
  connect(this->View, &SceneView::picked, edit, &EditPanel::aim);
  connect(edit, &EditPanel::editAsked, this, &MainWindow::editScene);
  connect(edit, &EditPanel::saveAsked, this, &MainWindow::saveSceneAs);
  connect(this->View, &SceneView::picked, probe, &ProbePanel::probe);
  connect(this->View, &SceneView::picked, line, &LinePanel::aim);
  connect(probe, &ProbePanel::marked, this, [this](const auto& lines) { this->mark(0, lines); });
  connect(line, &LinePanel::marked, this, [this](const auto& lines) { this->mark(1, lines); });
  connect(values, &ValuesPanel::placeChosen, this,
          [this](const Point& place) { this->mark(0, crossAt(place, this->Bench.scene()->size() / 60)); });
  connect(lens, &LensPanel::marked, this, [this](const auto& lines) { this->mark(2, lines); });
}

void MainWindow::mark(int kind, const QVector<QVector<Point>>& lines)
{
  this->Marks[kind] = lines;
  this->View->mark(this->Marks[0] + this->Marks[1] + this->Marks[2]);
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
  this->setWindowTitle(
      (this->Bench.isEdited() ? tr("%1, edited – Edge Studio") : tr("%1 – Edge Studio")).arg(scene->name()));
  this->Marks = {};
  const CameraPreset camera = this->View->camera();
  this->View->setScene(scene);
  if (scene->path() == this->ShownPath)  // edited or read again
    this->View->look(camera);
  this->ShownPath = scene->path();
  this->watchFile();
  this->listCameras();
  this->updatePicking();
  this->showResult();
  const vtkIdType polygons = scene->surfaces()->GetNumberOfCells(), lamps = scene->luminaires()->GetNumberOfPoints();
  QString about = polygons == 1 ? tr("1 polygon") : tr("%1 polygons").arg(grouped(polygons));
  about += lamps == 1 ? tr(", 1 luminaire") : tr(", %1 luminaires").arg(grouped(lamps));
  if (scene->isBareMesh())
    about = scene->facesOutward()
                ? tr("A mesh without light: reflectance 0.5 and 100 lm/m² on its fronts, which are outside")
                : tr("A mesh without light: reflectance 0.5 and 100 lm/m² everywhere");
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
  ShownPictures shown;
  if (result && this->Compare->showsDifference())
    shown = this->Compare->differencePicture();
  else if (two)
    shown = picturesOf(result, this->Compare->other(), display);
  else if (result)
    shown = pictureOf(result, this->Bench.onOneScale(), display);
  if (display.quantity == Quantity::Luminance && this->Bench.scene() && this->Bench.scene()->hasGloss())
    shown.legend.note = tr("diffuse part; gloss and mirrors: Image");
  const auto layout = !two                                     ? SceneView::Layout::Single
                      : mode == ComparePanel::Mode::SideBySide ? SceneView::Layout::SideBySide
                                                               : SceneView::Layout::Swipe;
  if (layout != this->View->layoutMode())
    this->View->setLayoutMode(layout);
  const QString caption = result ? describeShown(*result) : QString(),
                other = mode != ComparePanel::Mode::Off ? describeShown(*this->Compare->other()) : QString();
  this->View->setCaptions(
      result && this->Compare->showsDifference() ? tr("%1  minus  %2").arg(caption, other) : caption,
      two ? other : QString());
  this->View->paint(shown.first, shown.second, display);
  this->SceneLegend = shown.legend;
  this->showLegend();
}

bool MainWindow::showsImage() const
{
  return this->Centre->currentWidget() == this->Image;
}

void MainWindow::showLegend()
{
  this->Bar->setLegend(this->showsImage() ? this->Image->legend() : this->SceneLegend);
}

}  // namespace studio
