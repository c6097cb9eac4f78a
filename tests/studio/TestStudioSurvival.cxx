// SPDX-License-Identifier: BSD-3-Clause
// What is left of a session that was killed, or closed without being saved; and numbers in files of any locale.
#include <QDoubleSpinBox>
#include <QProcess>
#include <clocale>
#include <csignal>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "WindowTest.h"
#include "results/Export.h"
#include "session/Session.h"
#include "vtkDataArray.h"

using namespace studio;

namespace
{
/// Runs a method to its end and another one until it shows something; then the process is killed.
void dieWhileRunning(const QString& scene)
{
  MainWindow window;
  window.show();
  window.openFile(scene);
  Workbench* bench = window.bench();
  bench->setChosenSets({"desk"});
  MethodSettings settings;
  settings.trajectories = 64;
  bench->setSettings(settings);
  bench->run();
  while (bench->isRunning() || !bench->shown() || !bench->shown()->complete)
    QTest::qWait(10);
  settings.trajectories = 1000000000;
  bench->setSettings(settings);
  bench->run();
  while (bench->results().size() < 2)
    QTest::qWait(10);
  std::raise(SIGKILL);
}
}  // namespace

class TestStudioSurvival : public WindowTest
{
  Q_OBJECT

private:
  void runQuickly()
  {
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = 64;
    settings.delta = 0.125;
    bench->setSettings(settings);
    bench->run();
    QTRY_VERIFY(!bench->isRunning() && bench->shown() && bench->shown()->complete);
  }

private slots:
  void cleanup() { this->Window.reset(); }

  void killedSessionIsOfferedAgain()
  {
    removeSession(autosavePath());
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--die"), this->furnace()});
    QVERIFY(child.waitForFinished(60000));
    QCOMPARE(child.exitStatus(), QProcess::CrashExit);
    QVERIFY2(QFileInfo(autosavePath()).isFile(), "the session was saved before it died");
    this->open();
    const auto said = this->answer(QMessageBox::Yes);
    this->Window->offerAutosave();
    QVERIFY2(said->contains("did not end in an orderly way"), qPrintable(*said));
    Workbench* bench = this->Window->bench();
    QCOMPARE(this->Window->windowTitle(), QStringLiteral("furnace.json – Edge Studio"));
    QCOMPARE(bench->results().size(), 1);
    QCOMPARE(bench->shown()->trajectories, 64);
    QCOMPARE(bench->settings().trajectories, 1000000000);
    QVERIFY(this->Window->close());
    QVERIFY(!QFileInfo(autosavePath()).exists());
  }

  void closingLosesNothingThatWasFinished()
  {
    this->open();
    QVERIFY(this->Window->openFile(this->furnace()));
    this->runQuickly();
    const double lux = arrayOf(this->Window->bench()->shown()->set("desk"), "Illuminance")->GetComponent(7, 0);
    QVERIFY(this->Window->close());
    this->open();
    QVERIFY(this->Window->openFile(lastSessionPath()));
    const ResultPtr result = this->Window->bench()->shown();
    QVERIFY(result);
    QCOMPARE(arrayOf(result->set("desk"), "Illuminance")->GetComponent(7, 0), lux);
  }

  // Resident memory after 10 cycles and after 100 differs by less than 5 %; in every tenth the window is closed and
  // made anew.
  void memoryStaysFlat()
  {
    auto resident = [] {
#ifdef __GLIBC__
      malloc_trim(0);  // what is free but not given back yet is no leak
#endif
      QFile file("/proc/self/statm");
      return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(1).toDouble() : 0;
    };
    if (resident() == 0)
      QSKIP("the system does not tell the memory of a process");
    MethodSettings settings;
    settings.trajectories = 32;
    double early = 0;
    for (int cycle = 0; cycle < 100; ++cycle)
    {
      if (cycle % 10 == 0)
        this->open();
      Workbench* bench = this->Window->bench();
      bench->setSettings(settings);
      bench->markSaved();
      QVERIFY(this->Window->openFile(this->furnace()));
      bench->setChosenSets({"desk"});
      bench->run();
      QTRY_VERIFY(!bench->isRunning() && bench->shown());
      early = cycle == 9 ? resident() : early;
    }
    const double growth = resident() / early;
    figure("memory after 100 cycles of open, run and close, over that after 10", growth, "", 1.05);
    QVERIFY(growth < 1.05);
  }

  // Also run in a locale with decimal commas, see CMakeLists.txt.
  void numbersHavePointsInAnyLocale()
  {
    QCOMPARE(QByteArray(std::localeconv()->decimal_point), QByteArray("."));
    this->open();
    QVERIFY(this->Window->openFile(data("cornell/cornell-empty.json")));
    QCOMPARE(this->Window->bench()->scene()->cameras().front().position[1], -6.2);
    QVERIFY(this->Window->openFile(this->furnace()));
    QVERIFY(std::abs(this->Window->bench()->scene()->surfaces()->GetLength() - std::sqrt(16 + 9 + 6.25)) < 1e-6);
    this->runQuickly();
    const QString session = this->Folder.filePath("session.json");
    saveSession(*this->Window->bench(), this->Window->view()->camera(), session);
    QFile text(session);
    QVERIFY(text.open(QIODevice::ReadOnly) && text.readAll().contains("\"delta\": 0.125"));
    QFile csv(exportResult(*this->Window->bench()->shown(), this->Folder.filePath("out")).front());
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> row = csv.readAll().split('\n').at(1).split(',');
    QCOMPARE(row.size(), 9);
    QCOMPARE(row[0], QByteArray("0.25"));
    QVERIFY(std::abs(row[6].toDouble() - 250) < 50);
    this->Window->bench()->markSaved();
    QVERIFY(this->Window->openFile(session));
    QCOMPARE(this->Window->bench()->settings().delta, 0.125);
    QCOMPARE(this->find<QDoubleSpinBox>("delta")->text(), QStringLiteral("0.1250 m"));
  }
};

int main(int argc, char* argv[])
{
  std::setlocale(LC_ALL, "");
  if (qEnvironmentVariableIsSet("KALOS_DECIMAL_COMMA") && std::localeconv()->decimal_point[0] != ',')
    qFatal("the locale of this test is missing");
  if (argc == 3 && QByteArray(argv[1]) == "--die")
  {
    prepareApplication();
    QApplication application(argc, argv);
    prepareTest();
    dieWhileRunning(QString::fromLocal8Bit(argv[2]));
  }
  return runWindowTest<TestStudioSurvival>(argc, argv);
}

#include "TestStudioSurvival.moc"
