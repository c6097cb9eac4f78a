// SPDX-License-Identifier: BSD-3-Clause
// The real window's analysis: a probe, a line across an edge, two results compared, a study, speed.
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QTabWidget>
#include <QTableWidget>
#include <cmath>

#include "WindowTest.h"
#include "base/Problem.h"
#include "panels/ProbePanel.h"
#include "panels/SpeedPanel.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkKalosIlluminance.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

using namespace studio;

class TestStudioAnalysis : public WindowTest
{
  Q_OBJECT

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

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
    // 250 lx in the furnace; |t| < 9 with 7 degrees of freedom is exceeded once in 2e4.
    const Estimate estimate = *panel->pointProbe().estimate();
    QVERIFY(std::abs(estimate.value - 250) < 9 * estimate.error);
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
    // Some 40 points: |t| < 12.5 with 7 degrees of freedom for all, false alarm 2e-4.
    for (int i = 0; i < compensated.points.size(); ++i)
      QVERIFY(std::abs(compensated.points[i].y() - 250) < 12.5 / interval95 * compensated.halfWidth[i]);
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
    // One camera: what is turned on one side turns on both, and each half shows all that the whole did.
    vtkRendererCollection* renderers = this->Window->view()->renderWindow()->GetRenderers();
    renderers->InitTraversal();
    vtkCamera *left = renderers->GetNextItem()->GetActiveCamera(), *right = renderers->GetNextItem()->GetActiveCamera();
    left->Azimuth(7);
    this->Window->view()->renderWindow()->Render();
    for (int axis = 0; axis < 3; ++axis)
      QCOMPARE(right->GetPosition()[axis], left->GetPosition()[axis]);
    QCOMPARE(right->GetViewAngle(), left->GetViewAngle());
    const double shape = 0.5 * this->Window->view()->width() / this->Window->view()->height();
    QVERIFY(std::abs(shape * std::tan(left->GetViewAngle() * M_PI / 360) - std::tan(45 * M_PI / 360)) < 1e-9);
    this->Window->view()->look(bench->scene()->cameras().front());
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
    auto* legend = static_cast<LegendBar*>(this->find<QWidget>("studyLegend"));
    QVERIFY2(this->find<QLabel>("studyAbout")->text().contains("250 lx"), "the furnace is known");
    this->checkPictures(*grid, *legend);
    this->keep("10-study");
    QTest::mouseClick(grid->viewport(), Qt::LeftButton, Qt::NoModifier,
                      grid->visualItemRect(grid->item(0, 1)).center());
    QCOMPARE(bench->shownIndex(), 1);
    this->settle();
    QCOMPARE(static_cast<LegendBar*>(this->find<QWidget>("legend"))->legend().colours->GetTableRange()[1],
             legend->legend().colours->GetTableRange()[1]);

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

private:
  // The four pictures of a study have one scale, and words.
  void checkPictures(const QTableWidget& grid, const LegendBar& legend)
  {
    const Workbench* bench = this->Window->bench();
    double least = 1e9, most = 0;
    for (int cell = 0; cell < 4; ++cell)
    {
      const QTableWidgetItem* item = grid.item(cell / 2, cell % 2);
      QTRY_VERIFY(item && !item->icon().isNull());
      QVERIFY2(
          item->text().contains("error ") && item->text().contains("bias ") && item->text().endsWith(QLatin1Char('s')),
          qPrintable(item->text()));
      // All on one scale: in the middle of the desk each picture has the colour of the mean of the four cells there.
      vtkDataArray* lux = arrayOf(bench->results()[cell]->set("desk"), "Illuminance");
      const double middle =
          (lux->GetComponent(19, 0) + lux->GetComponent(20, 0) + lux->GetComponent(27, 0) + lux->GetComponent(28, 0)) /
          4;
      const unsigned char* wanted = legend.legend().colours->MapValue(middle);
      const QImage picture = item->icon().pixmap(132).toImage();
      const QColor found = picture.pixelColor(picture.width() / 2, picture.height() / 2);
      QVERIFY2(
          std::abs(found.red() - wanted[0]) + std::abs(found.green() - wanted[1]) + std::abs(found.blue() - wanted[2]) <
              12,
          qPrintable(QStringLiteral("%1: %2").arg(cell).arg(found.name())));
      const double top = rangeOf({bench->results()[cell]}, bench->display())[1];
      least = std::min(least, top);
      most = std::max(most, top);
    }
    QVERIFY2(least < most, "scales of their own would differ");
    QCOMPARE(legend.legend().colours->GetTableRange()[1], rangeOf(bench->results(), bench->display())[1]);
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioAnalysis>(argc, argv);
}

#include "TestStudioAnalysis.moc"
