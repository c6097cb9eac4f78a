// SPDX-License-Identifier: BSD-3-Clause
// The office of 275 000 triangles in the real window: how long one waits for it, and how smoothly it turns.
#include <QApplication>
#include <QElapsedTimer>

#include "Application.h"
#include "Helpers.h"
#include "MainWindow.h"
#include "vtkInteractorObserver.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

using namespace studio;

class TestStudioLargeScene : public QObject
{
  Q_OBJECT

private:
  static void report(const char* what, double value, const char* unit)
  {
    qInfo("large scene: %s %.2f %s", what, value, unit);
  }

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

  void officeIsUsable()
  {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QElapsedTimer clock;
    clock.start();
    auto seconds = [&clock] { return static_cast<double>(clock.elapsed()) / 1000; };
    QVERIFY(window.openFile(QStringLiteral(KALOS_OFFICE "/office.json")));
    window.view()->renderWindow()->Render();
    report("first picture after", seconds(), "s");
    QVERIFY(window.bench()->scene()->surfaces()->GetNumberOfCells() > 200000);

    clock.restart();
    QVector<double> pictures;
    connect(window.bench(), &Workbench::resultsChanged, &window, [&] {
      if (window.bench()->shown())
        pictures << seconds();
    });
    window.bench()->run();
    QTRY_VERIFY_WITH_TIMEOUT(pictures.size() >= 4, 120000);
    for (double at : pictures)
      report("colours after", at, "s");
    QTest::qWait(200);
    QVERIFY(window.grab().save(QStringLiteral(KALOS_SCREENSHOTS "/13-office.png")));

    auto* style = window.view()->interactor()->GetInteractorStyle();
    style->InvokeEvent(vtkCommand::StartInteractionEvent);
    clock.restart();
    constexpr int turns = 10;
    for (int i = 0; i < turns; ++i)
    {
      window.view()->lookAlong({0.35, 0.8, -0.45 - 0.01 * i}, {0, 0, 1});
      window.view()->renderWindow()->Render();
    }
    report("frames a second while computing", turns / seconds(), "");
    style->InvokeEvent(vtkCommand::EndInteractionEvent);
    clock.restart();
    window.bench()->cancel();
    QTRY_VERIFY(!window.bench()->isRunning());
    report("cancelled after", seconds(), "s");
  }
};

int main(int argc, char* argv[])
{
  prepareApplication();
  QApplication application(argc, argv);
  dressApplication();
  TestStudioLargeScene test;
  return QTest::qExec(&test, argc, argv);
}

#include "TestStudioLargeScene.moc"
