// SPDX-License-Identifier: BSD-3-Clause
// A scene is lit as soon as it is open, and drawing leaves the processor to the run.
#include <QAction>
#include <QComboBox>
#include <ctime>

#include "WindowTest.h"
#include "scene/NearestEdge.h"
#include "session/RedrawBudget.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosEstimatorAlgorithm.h"
#include "vtkRenderWindow.h"

using namespace studio;

class TestStudioLight : public WindowTest
{
  Q_OBJECT

  /// Seconds of processor time of all threads.
  static double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

  void openedSceneIsLitUnasked()
  {
    this->find<QAction>("light")->setChecked(true);
    QElapsedTimer clock;
    clock.start();
    QVERIFY(this->Window->openFile(demoScene()));
    this->Window->view()->renderWindow()->Render();
    figure("grey picture of the demo scene", seconds(clock), "s", 1);
    clock.restart();
    Workbench* bench = this->Window->bench();
    auto lit = [&] { return bench->shown() && !bench->shown()->preview; };
    QTRY_VERIFY_WITH_TIMEOUT(lit() && (bench->shown()->quality.typical <= 0.05 || bench->shown()->complete), 40000);
    figure("lit picture of the demo scene", seconds(clock), "s", 2);
    figure("standard error of it", 100 * bench->shown()->quality.typical, "%", 5);
    QCOMPARE(bench->shown()->settings.method, static_cast<int>(vtkKalosEstimatorAlgorithm::GATHERED));
    this->keep("21-lit-unasked");
    QTRY_VERIFY_WITH_TIMEOUT(bench->shown()->settings == bench->settings(), 40000);
    QVERIFY2(this->find<QPushButton>("run")->isEnabled(), "an asked run takes the place of it");
    QVERIFY2(!bench->unsaved(), "nobody asked for it");
    QVERIFY2(this->Window->openFile(this->furnace()), "so that nothing is asked now");
    this->find<QAction>("light")->setChecked(false);
    QVERIFY(this->Window->openFile(demoScene()));
    QVERIFY(!bench->isRunning());
  }

  // How far one cell is from what both methods have on average, by its distance from an edge.
  void mainPictureShowsWhatMethodsDoAtEdges()
  {
    QVERIFY(this->Window->openFile(demoScene()));
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({SceneDocument::paintedName()});
    MethodSettings compensated, local;
    compensated.trajectories = local.trajectories = 4096;
    local.method = vtkKalosEstimatorAlgorithm::LOCAL;
    local.seed = 2;
    bench->runSeries({compensated, local});
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->results().size() == 2, 120000);
    vtkDataSet *a = bench->results()[0]->set(SceneDocument::paintedName()),
               *b = bench->results()[1]->set(SceneDocument::paintedName());
    double near = 0, far = 0;
    int nearCells = 0, farCells = 0;
    for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
    {
      const double lux = arrayOf(a, "Illuminance")->GetComponent(i, 0),
                   off = std::abs(arrayOf(b, "Illuminance")->GetComponent(i, 0) - lux);
      const double distance = nearestEdge(*bench->scene(), receiverPosition(a, i))->distance;
      if (!(lux > 0) || (distance > 0.03 && distance < 0.5))
        continue;
      (distance < 0.1 ? near : far) += off / lux;
      ++(distance < 0.1 ? nearCells : farCells);
    }
    QVERIFY2(nearCells > 500 && farCells > 500, qPrintable(QStringLiteral("%1 %2").arg(nearCells).arg(farCells)));
    near /= nearCells;
    far /= farCells;
    QVERIFY2(near > 0.2 && near > 3 * far, qPrintable(QStringLiteral("%1 beside %2").arg(near).arg(far)));
    auto* mode = this->find<QComboBox>("compareMode");
    mode->setCurrentIndex(1);
    emit mode->activated(1);
    this->keep("23-local-beside-compensated");
  }

  void redrawsWaitForTheirShare()
  {
    RedrawBudget budget(0.08);
    QElapsedTimer clock;
    budget.redrawn();
    clock.start();
    while (clock.elapsed() < 40)
    {
    }
    // 40 ms are 8 % of 500 ms, of which 40 ms have passed.
    QVERIFY2(budget.wait() >= 455, qPrintable(QString::number(budget.wait())));
    QTRY_COMPARE_WITH_TIMEOUT(budget.wait(), 0, 5000);
  }

  // What the process takes beyond the solve: drawing, set-up, and the tables of the window.
  void drawingIsASmallPartOfARun()
  {
    QVERIFY(this->Window->openFile(demoScene()));
    this->Window->resize(2560, 1440);
    this->settle();
    Workbench* bench = this->Window->bench();
    MethodSettings settings;
    settings.trajectories = 4096;
    bench->setSettings(settings);
    const double before = processor();
    int pictures = 0;
    connect(bench, &Workbench::resultsChanged, this, [&] { ++pictures; });
    QElapsedTimer clock;
    clock.start();
    this->click("run");
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning(), 300000);
    const double all = processor() - before, solve = bench->shown()->cpuSeconds;
    QVERIFY2(pictures >= 3, qPrintable(QString::number(pictures)));
    figure("time of a run in a large window", seconds(clock), "s", 20);
    figure("processor time beside the solve in a large window, over that of the solve", all / solve - 1, "", 0.15);
    this->keep("22-large-window");
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioLight>(argc, argv);
}

#include "TestStudioLight.moc"
