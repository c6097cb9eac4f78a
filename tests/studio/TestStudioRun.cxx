// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's runs, without a widget: they refine, rest, stop, fail with a reason, and their results stay.
#include <QElapsedTimer>
#include <QSignalSpy>

#include "ModelTest.h"
#include "base/DataSets.h"
#include "session/Workbench.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkKalosIlluminance.h"

using namespace studio;

class TestStudioRun : public ModelTest
{
  Q_OBJECT

private slots:
  // 250 lx in the furnace at every receiver; Student with 7 degrees of freedom and Sidak for some 4000 points: |t| <
  // 19 has a false-alarm rate of 1e-3.
  void runRefinesToTheTruth()
  {
    const ScenePtr scene = this->furnace();
    Run run(scene, scene->receivers({"desk", "surfaces"}), quick(3200));
    QSignalSpy refined(&run, &Run::refined), ended(&run, &Run::ended);
    QVERIFY(ended.wait(60000));
    QCOMPARE(run.state(), Run::State::Finished);
    QVERIFY(refined.count() >= 2);
    const ResultPtr result = run.result();
    QVERIFY(result->complete);
    QCOMPARE(result->trajectories, 3200);
    QVERIFY(result->quality.typical > 0 && result->quality.typical < 0.05);
    for (const NamedSet& set : dataSets(result->data))
      for (vtkIdType i = 0; i < set.data->GetNumberOfCells(); ++i)
      {
        const double lux = arrayOf(set.data, "Illuminance")->GetComponent(i, 0),
                     error = arrayOf(set.data, "IlluminanceStandardError")->GetComponent(i, 0);
        QVERIFY2(std::abs(lux - 250) < 19 * error, qPrintable(QString("%1 ± %2").arg(lux).arg(error)));
        if (vtkDataArray* luminance = arrayOf(set.data, "Luminance"))
          QVERIFY(std::abs(luminance->GetComponent(i, 0) - (0.6 * lux + 100) / M_PI) < 1e-9 * lux);
      }
    QVERIFY(arrayOf(result->set("surfaces"), "Luminance"));
  }

  void firstColoursCoverEverything()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    const auto receivers = scene->receivers(scene->usualSets());
    Run run(scene, receivers, quick(100000000));
    QSignalSpy refined(&run, &Run::refined);
    QElapsedTimer clock;
    clock.start();
    QVERIFY(refined.wait(20000));
    figure("first colours", seconds(clock), "s", 1);
    QVERIFY(run.result()->preview && !run.result()->complete);
    QCOMPARE(dataSets(run.result()->data).size(), 3);
    for (const NamedSet& set : dataSets(run.result()->data))
    {
      vtkDataSet* whole = dataSets(scene->receivers({set.name})).front().data;
      QCOMPARE(set.data->GetNumberOfCells(), whole->GetNumberOfCells());
      QVERIFY(arrayOf(set.data, "Illuminance")->GetRange()[1] > 50);
      // The lamp hangs from the ceiling, which takes nothing over from walls and sees no direct light.
      vtkIdType ceiling = 0, lit = 0;
      for (vtkIdType i = 0; i < whole->GetNumberOfCells(); ++i)
        if (whole->GetCellData()->GetNormals()->GetComponent(i, 2) < -0.99)
        {
          ++ceiling;
          lit += arrayOf(set.data, "DirectIlluminance")->GetComponent(i, 0) > 0;
        }
      QVERIFY(lit == 0 && (set.name != "surfaces" || ceiling > 100));
    }
  }

  void runRestsAndGoesOn()
  {
    const ScenePtr scene = this->furnace();
    MethodSettings settings;
    settings.goal = Goal::Time;
    settings.seconds = 1;
    QElapsedTimer clock;
    clock.start();
    Run run(scene, scene->receivers({"desk"}), settings);
    QSignalSpy refined(&run, &Run::refined), ended(&run, &Run::ended);
    QVERIFY(refined.wait(5000));
    run.pause();
    QTest::qWait(200);  // what was under way ends
    const ResultPtr before = run.result();
    const double elapsed = run.elapsed();
    QTest::qWait(1500);
    QCOMPARE(run.result(), before);
    QCOMPARE(run.elapsed(), elapsed);
    QVERIFY(run.active());
    run.resume();
    QVERIFY(ended.wait(5000));
    QVERIFY(run.result()->trajectories > before->trajectories);
    // A busy machine may overrun the second asked for, but not the clock.
    QVERIFY2(run.result()->seconds < seconds(clock) - 1.5, "the pause is not part of the time");
  }

  void timeLeftIsThatOfTheLastStep()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    MethodSettings settings;
    settings.goal = Goal::Time;
    settings.seconds = 3;
    Run run(scene, scene->receivers(scene->usualSets()), settings);
    QVector<double> ends;  // s after the start, as they were foretold
    connect(&run, &Run::progressed, this, [&] {
      if (run.progress() > 0.4 && run.remaining())
        ends << run.elapsed() + *run.remaining();
    });
    QSignalSpy ended(&run, &Run::ended);
    QVERIFY(ended.wait(60000));
    QVERIFY(!run.remaining());
    QVERIFY(!ends.isEmpty());
    for (const double end : ends)
      QVERIFY2(std::abs(end - run.elapsed()) < 0.4 * run.elapsed(),
               qPrintable(QStringLiteral("%1 s were foretold, it took %2 s").arg(end).arg(run.elapsed())));
  }

  void cancelIsQuickAndKeepsTheLastRound()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    Run run(scene, scene->receivers(scene->usualSets()), quick(100000000));
    QSignalSpy refined(&run, &Run::refined), ended(&run, &Run::ended);
    QVERIFY(refined.wait(20000));
    QTest::qWait(500);
    QElapsedTimer clock;
    clock.start();
    run.cancel();
    QVERIFY(ended.wait(5000));
    figure("cancel", seconds(clock), "s", 0.2);
    QCOMPARE(run.state(), Run::State::Cancelled);
    QVERIFY(run.result() && !run.result()->complete);
  }

  void runEndsAtItsError()
  {
    const ScenePtr scene = this->furnace();
    MethodSettings settings;
    settings.goal = Goal::Error;
    settings.relativeError = 0.01;
    Run run(scene, scene->receivers({"desk"}), settings);
    QSignalSpy ended(&run, &Run::ended);
    QVERIFY(ended.wait(60000));
    QCOMPARE(run.state(), Run::State::Finished);
    // Half-width of the 95 % interval, Student with 7 degrees of freedom.
    QVERIFY2(2.3646 * run.result()->quality.largest <= 0.01,
             qPrintable(QString::number(run.result()->quality.largest)));
    QVERIFY2(run.result()->quality.largest > 0.002, qPrintable(QString::number(run.result()->quality.largest)));
  }

  void failureHasItsReason()
  {
    Workbench bench;
    bench.open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
    MethodSettings settings = quick(100);
    settings.method = vtkKalosIlluminance::CLAMPED;
    settings.delta = 1000;
    bench.setSettings(settings);
    QSignalSpy problem(&bench, &Workbench::problem);
    bench.run();
    QVERIFY(problem.wait(5000));
    QVERIFY(problem.front().front().toString().startsWith("delta: is 1000"));
    QVERIFY(bench.results().isEmpty());
  }

  void benchKeepsEveryResult()
  {
    Workbench bench;
    bench.open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
    bench.setChosenSets({"desk"});
    for (int method : {vtkKalosIlluminance::LOCAL, vtkKalosIlluminance::DISC})
    {
      MethodSettings settings = quick(64);
      settings.method = method;
      bench.setSettings(settings);
      bench.run();
      QTRY_VERIFY(!bench.isRunning());
      QTRY_VERIFY(bench.shown() && bench.shown()->complete);
      QCOMPARE(bench.shown()->settings.method, method);
    }
    QCOMPARE(bench.results().size(), 2);
    bench.show(0);
    QCOMPARE(bench.shown()->settings.method, static_cast<int>(vtkKalosIlluminance::LOCAL));
    bench.open(data("cornell/cornell-empty.json"));
    QVERIFY(bench.results().isEmpty() && !bench.shown());
  }
};

QTEST_GUILESS_MAIN(TestStudioRun)
#include "TestStudioRun.moc"
