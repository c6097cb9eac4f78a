// SPDX-License-Identifier: BSD-3-Clause
// The real window on a virtual screen: open, run, pause, cancel, bad input, drag and drop.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QMouseEvent>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>

#include "Export.h"
#include "ProbePanel.h"
#include "Problem.h"
#include "RecentFiles.h"
#include "Session.h"
#include "SpeedPanel.h"
#include "WindowTest.h"
#include "vtkDataArray.h"
#include "vtkInteractorObserver.h"
#include "vtkKalosIlluminance.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

using namespace studio;

class TestStudioWindow : public WindowTest
{
  Q_OBJECT

private:
  static int coloured(const QImage& image)
  {
    int count = 0;
    for (int y = 0; y < image.height(); y += 4)
      for (int x = 0; x < image.width(); x += 4)
        count += image.pixelColor(x, y).saturation() > 120;
    return count;
  }

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

  void showsTheDemoScene()
  {
    this->Window.reset();
    QElapsedTimer clock;
    clock.start();
    this->init();
    QVERIFY(this->Window->openFile(demoScene()));
    this->Window->view()->renderWindow()->Render();
    figure("first picture of the demo scene", seconds(clock), "s", 3);
    QVERIFY(this->Window->windowTitle().startsWith("cornell.json"));
    this->keep("01-open");
  }

  void runsAndRefines()
  {
    this->Window->openFile(demoScene());
    this->settle();
    const int before = coloured(this->Window->view()->picture());
    this->find<QDoubleSpinBox>("amount")->setValue(128);
    QElapsedTimer clock;
    clock.start();
    this->click("run");
    QTRY_VERIFY_WITH_TIMEOUT(this->Window->bench()->shown(), 20000);
    figure("first colours of the demo scene", seconds(clock), "s", 1);
    QVERIFY(this->find<QPushButton>("cancel")->isEnabled());
    this->settle();
    auto* style = this->Window->view()->interactor()->GetInteractorStyle();
    style->InvokeEvent(vtkCommand::StartInteractionEvent);
    QElapsedTimer frames;
    frames.start();
    SceneView* view = this->Window->view();
    constexpr int turns = 20;
    for (int i = 0; i < turns; ++i)
    {
      view->lookAlong({0.35, 0.8, -0.45 - 0.01 * i}, {0, 0, 1});
      view->renderWindow()->Render();
    }
    figure("frame while computing", seconds(frames) / turns, "s", 0.05);
    style->InvokeEvent(vtkCommand::EndInteractionEvent);
    view->look(this->Window->bench()->scene()->cameras().front());
    this->settle();
    QVERIFY(coloured(this->Window->view()->picture()) > before + 1000);
    this->keep("02-running");
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->isRunning(), 120000);
    QVERIFY(this->find<QLabel>("errors")->text().contains("128 trajectories"));
    this->keep("03-finished");
    this->find<QCheckBox>("isolines")->click();
    this->find<QComboBox>("scale")->setCurrentIndex(1);
    emit this->find<QComboBox>("scale")->activated(1);
    QVERIFY(this->Window->bench()->display().isolines && this->Window->bench()->display().scale == Scale::Logarithmic);
    this->keep("04-isolines");

    // What the README shows: every method across the edge at the foot of the back wall.
    Display display = this->Window->bench()->display();
    display.isolines = false;
    display.scale = Scale::Linear;
    display.hidden = QStringList{"desk"};
    this->Window->bench()->setDisplay(display);
    this->settle();
    this->find<QTabWidget>("tabs")->setCurrentIndex(1);
    QTest::mouseClick(this->Window->view(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(this->Window->view()->width() / 2 - 60, this->Window->view()->height() * 5 / 10));
    this->find<QDoubleSpinBox>("amount")->setValue(1024);
    this->click("measure");
    auto* line = this->Window->findChild<LinePanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!line->lineProbe().active(), 120000);
    QCOMPARE(line->lineProbe().chart().series.first().name, QStringLiteral("reference"));
    this->keep("12-across-an-edge");
  }

  // Resident memory after 10 cycles and after 100 differs by less than 5 %.
  void memoryStaysFlat()
  {
    auto resident = [] {
      QFile file("/proc/self/statm");
      return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toDouble() : 0;
    };
    if (resident() == 0)
      QSKIP("the system does not tell the memory of a process");
    MethodSettings settings;
    settings.trajectories = 32;
    Workbench* bench = this->Window->bench();
    bench->setSettings(settings);
    double early = 0;
    for (int cycle = 0; cycle < 100; ++cycle)
    {
      QVERIFY(this->Window->openFile(this->furnace()));
      bench->setChosenSets({"desk"});
      bench->run();
      QTRY_VERIFY(!bench->isRunning() && bench->shown());
      early = cycle == 10 ? resident() : early;
    }
    qInfo("figure: memory after 100 cycles is %.3f of that after 10 (at most 1.05)", resident() / early);
    QVERIFY(resident() < 1.05 * early);
  }

  void pausesGoesOnAndCancels()
  {
    this->Window->openFile(this->furnace());
    this->find<QDoubleSpinBox>("amount")->setValue(1e9);
    this->click("run");
    QTRY_VERIFY(this->Window->bench()->shown());
    this->click("pause");
    QCOMPARE(this->find<QPushButton>("pause")->text(), QStringLiteral("Continue"));
    QVERIFY(this->find<QLabel>("times")->text().contains("paused"));
    this->click("pause");
    const ResultPtr before = this->Window->bench()->shown();
    QTRY_VERIFY(this->Window->bench()->shown() != before);
    QElapsedTimer clock;
    clock.start();
    this->click("cancel");
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->isRunning(), 5000);
    figure("cancel", seconds(clock), "s", 0.2);
    QTRY_VERIFY(this->find<QLabel>("times")->text().contains("cancelled"));
    QVERIFY(!this->Window->bench()->shown()->complete);
  }

  void probesAPointAndALine()
  {
    this->Window->openFile(this->furnace());
    MethodSettings settings;
    settings.trajectories = 1024;
    this->Window->bench()->setSettings(settings);
    this->Window->bench()->setChosenSets({"surfaces"});
    this->click("run");
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->isRunning() && this->Window->bench()->shown(), 60000);
    Display display = this->Window->bench()->display();
    display.hidden = QStringList{"desk"};
    this->Window->bench()->setDisplay(display);
    this->Window->view()->look({"corner", {3.4, 0.5, 2.1}, {0.8, 1.8, 0.2}, {0, 0, 1}, 70});
    this->settle();
    QTest::mouseClick(this->Window->view(), Qt::LeftButton, Qt::NoModifier,
                      this->Window->view()->rect().center() + QPoint(0, 60));
    auto* value = this->find<QLabel>("probeValue");
    QTRY_VERIFY(value->text().endsWith(" lx"));
    QVERIFY(this->find<QLabel>("probePlace")->text().contains("from an edge of 90°"));
    auto* panel = this->Window->findChild<ProbePanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!panel->pointProbe().active(), 60000);
    // 250 lx in the furnace; |t| < 5 with 31 degrees of freedom is exceeded once in 5e4.
    const Estimate estimate = *panel->pointProbe().estimate();
    QVERIFY(std::abs(estimate.value - 250) < 5 * estimate.error);
    this->keep("05-probe");

    this->find<QTabWidget>("tabs")->setCurrentIndex(1);
    this->click("measure");
    auto* line = this->Window->findChild<LinePanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!line->lineProbe().active(), 120000);
    const Chart chart = line->lineProbe().chart();
    QCOMPARE(chart.series.size(), methods().size() + 1);
    QCOMPARE(chart.series.last().name, QStringLiteral("truth"));
    const Series& compensated = chart.series.first();
    QCOMPARE(compensated.points.first().x(), 1e-4);
    // Some 40 points: |t| < 5.5 for all, false alarm 2e-4.
    for (int i = 0; i < compensated.points.size(); ++i)
      QVERIFY(std::abs(compensated.points[i].y() - 250) < 5.5 / interval95 * compensated.halfWidth[i]);
    this->keep("06-line");
    for (const char* suffix : {"svg", "png", "csv"})
      ChartView::save(chart, this->Folder.filePath(QStringLiteral("line.") + suffix));
    QFile csv(this->Folder.filePath("line.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(csv.readAll().contains("\"compensated\",0.0001,"));
    QVERIFY(QFileInfo(this->Folder.filePath("line.svg")).size() > 2000);
    QCOMPARE(QImage(this->Folder.filePath("line.png")).size(), QSize(1440, 960));
    QVERIFY_EXCEPTION_THROWN(ChartView::save(chart, "/nowhere/line.csv"), Problem);
  }

  void comparesTwoMethods()
  {
    this->Window->openFile(demoScene());
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"surfaces"});
    MethodSettings local, disc;
    local.trajectories = disc.trajectories = 128;
    local.method = vtkKalosIlluminance::LOCAL;
    disc.method = vtkKalosIlluminance::DISC;
    disc.epsilon = 0.3;
    disc.seed = 2;
    bench->runSeries({local, disc});
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->seriesLeft() == 0, 120000);
    QTRY_COMPARE(bench->results().size(), 2);
    this->find<QTabWidget>("tabs")->setCurrentIndex(2);
    QCOMPARE(this->find<QListWidget>("results")->count(), 2);
    auto* mode = this->find<QComboBox>("compareMode");
    auto choose = [&](int index) {
      mode->setCurrentIndex(index);
      emit mode->activated(index);
      this->settle();
    };
    choose(1);
    QCOMPARE(this->Window->view()->layoutMode(), SceneView::Layout::SideBySide);
    this->keep("07-side-by-side");
    choose(2);
    SceneView* view = this->Window->view();
    const QPoint middle(view->width() / 2, view->height() / 2);
    const CameraPreset before = view->camera();
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, middle);
    // QTest would move the pointer and leave it to the screen to tell.
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(-view->width() / 5, 0), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(view, &move);
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(-view->width() / 5, 0));
    QVERIFY(std::abs(view->swipe() - 0.3) < 0.02);
    QCOMPARE(view->camera().position, before.position);
    this->keep("08-swipe");
    choose(3);
    QVERIFY(this->find<QLabel>("compareAbout")->text().contains("differ by more than two standard errors"));
    this->keep("09-difference");
  }

  void studiesAGridAndSpeed()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.method = vtkKalosIlluminance::SPHERE_EXACT;
    bench->setSettings(settings);
    this->Window->view()->lookAlong({0, 0, -1}, {0, 1, 0});
    this->find<QTabWidget>("tabs")->setCurrentIndex(3);
    this->find<QLineEdit>("studyTrajectories")->setText("64, 512");
    this->find<QLineEdit>("studyEpsilons")->setText("0.1, auto");
    this->click("study");
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->results().size() == 4, 60000);
    this->settle();
    auto* grid = this->find<QTableWidget>("studyGrid");
    QCOMPARE(grid->rowCount(), 2);
    QCOMPARE(grid->columnCount(), 2);
    for (int cell = 0; cell < 4; ++cell)
    {
      QVERIFY(grid->item(cell / 2, cell % 2));
      QVERIFY2(grid->item(cell / 2, cell % 2)->text().contains("mean"), "the furnace is known");
    }
    this->keep("10-study");
    emit grid->cellClicked(0, 1);
    QCOMPARE(bench->shownIndex(), 1);

    const auto said = this->answer(QMessageBox::Ok);
    this->find<QLineEdit>("studyEpsilons")->setText("0.1, -2");
    this->click("study");
    QTRY_VERIFY(said->contains("epsilons"));

    this->find<QTabWidget>("tabs")->setCurrentIndex(4);
    settings.trajectories = 512;
    bench->setSettings(settings);
    this->click("runAll");
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->results().size() == 4 + methods().size(), 60000);
    const Chart chart = this->Window->findChild<SpeedPanel*>()->chart();
    QCOMPARE(chart.series.size(), bench->results().size());
    QVERIFY(chart.series.last().points.size() > 1);
    this->keep("11-speed");
  }

  void sessionReopens()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = 64;
    bench->setSettings(settings);
    Display display;
    display.scale = Scale::Logarithmic;
    bench->setDisplay(display);
    this->click("run");
    QTRY_VERIFY(!bench->isRunning() && bench->shown() && bench->shown()->complete);
    QVERIFY2(QFileInfo(autosavePath()).isFile(), "a crash now would leave a session");
    this->Window->view()->look({"", {3, 1, 2}, {1, 1, 0}, {0, 0, 1}, 50});
    const QString path = this->Folder.filePath("session.json");
    saveSession(*bench, this->Window->view()->camera(), path);
    const double lux = arrayOf(bench->shown()->set("desk"), "Illuminance")->GetComponent(7, 0);
    this->cleanup();
    this->init();
    QVERIFY(this->Window->openFile(path));
    bench = this->Window->bench();
    QVERIFY(bench->settings() == settings && bench->display() == display);
    QCOMPARE(bench->chosenSets(), QStringList{"desk"});
    QCOMPARE(this->Window->view()->camera().position[0], 3.0);
    QCOMPARE(bench->shown()->trajectories, 64);
    QCOMPARE(arrayOf(bench->shown()->set("desk"), "Illuminance")->GetComponent(7, 0), lux);

    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    const QString broken =
        writeFile(this->Folder.path(), "bad-session.json", QByteArray(text).replace("\"seed\": 1", "\"seed\": -1"));
    const auto said = this->answer(QMessageBox::Ok);
    QVERIFY(!this->Window->openFile(broken));
    QVERIFY2(said->contains("bad-session.json") && said->contains("session/settings/seed"), qPrintable(*said));
    QCOMPARE(this->Window->bench()->results().size(), 1);
    this->Window->close();
    QVERIFY(!QFileInfo(autosavePath()).exists());
  }

  void exportsPictureAndValues()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = 64;
    bench->setSettings(settings);
    this->click("run");
    QTRY_VERIFY(!bench->isRunning() && bench->shown() && bench->shown()->complete);
    this->settle();
    const QImage image = this->Window->pictureWithLegend();
    QVERIFY(image.width() > this->Window->view()->width());
    const QStringList paths = exportResult(*bench->shown(), this->Folder.filePath("out"));
    QCOMPARE(paths.size(), 2);
    QFile csv(paths.front());
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
    QCOMPARE(lines.front(), QByteArray("x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,direct_lx"));
    QCOMPARE(lines.size(), 49);
    QVERIFY(lines[1].startsWith("0.25,0.25,0.75,0,0,1,"));
    QVERIFY_EXCEPTION_THROWN(exportResult(*bench->shown(), "/proc/nowhere"), Problem);
  }

  void brokenSceneSaysWhereAndTheOldOneStays()
  {
    this->Window->openFile(this->furnace());
    const QString broken =
        writeFile(this->Folder.path(), "broken.json", QByteArray(furnaceRoom()).replace("0.6", "1.6"));
    const auto said = this->answer(QMessageBox::Ok);
    QVERIFY(!this->Window->openFile(broken));
    QVERIFY2(said->contains("broken.json") && said->contains("Where: materials.glow.reflectance") &&
                 said->contains("What: found 1.6; expected "),
             qPrintable(*said));
    QVERIFY(this->Window->windowTitle().startsWith("furnace.json"));
  }

  void droppedSceneIsOpened()
  {
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(data("sphere/sphere-2.obj"))});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &drop);
    QVERIFY(this->Window->windowTitle().startsWith("sphere-2.obj"));
    QVERIFY(recentFiles().front().endsWith("sphere-2.obj"));
  }

  void settingsOfThePanelCanBeUndone()
  {
    auto* amount = this->find<QDoubleSpinBox>("amount");
    const double before = amount->value();
    amount->setValue(100);
    QCOMPARE(this->Window->bench()->settings().trajectories, 100);
    this->find<QAction>("undo")->trigger();
    QCOMPARE(amount->value(), before);
  }

  void closingWhileRunningAsks()
  {
    this->Window->openFile(this->furnace());
    this->find<QDoubleSpinBox>("amount")->setValue(1e9);
    this->click("run");
    auto said = this->answer(QMessageBox::No);
    QVERIFY(!this->Window->close());
    QVERIFY(said->startsWith("A run is under way."));
    QVERIFY(this->Window->bench()->isRunning());
    this->answer(QMessageBox::Yes);
    QVERIFY(this->Window->close());
    QTRY_VERIFY(!this->Window->bench()->isRunning());
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioWindow>(argc, argv);
}

#include "TestStudioWindow.moc"
