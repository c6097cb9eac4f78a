// SPDX-License-Identifier: BSD-3-Clause
// The office of 275 000 triangles in the real window: how long one waits for it, and how smoothly it turns.
#include "WindowTest.h"
#include "vtkInteractorObserver.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

using namespace studio;

class TestStudioLargeScene : public WindowTest
{
  Q_OBJECT

private slots:
  void officeIsUsable()
  {
    this->open();
    QElapsedTimer clock;
    clock.start();
    QVERIFY(this->Window->openFile(QStringLiteral(KALOS_OFFICE "/office.json")));
    SceneView* view = this->Window->view();
    view->renderWindow()->Render();
    figure("first picture of the office", seconds(clock), "s", 5);
    Workbench* bench = this->Window->bench();
    QVERIFY(bench->scene()->surfaces()->GetNumberOfCells() > 200000);
    QVERIFY(bench->scene()->painted().receivers->GetNumberOfCells() < 17000);

    clock.restart();
    QVector<double> pictures;
    double whole = 0;
    connect(bench, &Workbench::resultsChanged, this, [&] {
      if (bench->shown())
        pictures << seconds(clock);
      if (whole == 0 && bench->shown() && !bench->shown()->preview)
        whole = seconds(clock);
    });
    bench->run();
    QTRY_VERIFY_WITH_TIMEOUT(whole > 0, 120000);
    figure("first colours of the office", pictures[0], "s", 4);
    figure("second picture of the office", pictures[1], "s", 6);
    figure("every point of the office", whole, "s", 12);
    this->keep("13-office");

    auto* style = view->interactor()->GetInteractorStyle();
    style->InvokeEvent(vtkCommand::StartInteractionEvent);
    clock.restart();
    constexpr int turns = 10;
    for (int i = 0; i < turns; ++i)
    {
      view->lookAlong({0.35, 0.8, -0.45 - 0.01 * i}, {0, 0, 1});
      view->renderWindow()->Render();
    }
    figure("frame of the office while computing", seconds(clock) / turns, "s", 0.1);
    style->InvokeEvent(vtkCommand::EndInteractionEvent);
    clock.restart();
    bench->cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning(), 10000);
    figure("cancel of the office", seconds(clock), "s", 0.2);
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioLargeScene>(argc, argv);
}

#include "TestStudioLargeScene.moc"
