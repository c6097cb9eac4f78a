// SPDX-License-Identifier: BSD-3-Clause
// The real window on a virtual screen: open, run, pause, cancel, bad input, drag and drop.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QSpinBox>
#include <QTabWidget>

#include "WindowTest.h"
#include "panels/ProbePanel.h"
#include "session/Preferences.h"
#include "vtkInteractorObserver.h"
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

  /// Seconds that a frame takes while the scene is turned.
  double frame()
  {
    SceneView* view = this->Window->view();
    auto* style = view->interactor()->GetInteractorStyle();
    style->InvokeEvent(vtkCommand::StartInteractionEvent);
    QElapsedTimer clock;
    clock.start();
    constexpr int turns = 20;
    for (int i = 0; i < turns; ++i)
    {
      view->lookAlong({0.35, 0.8, -0.45 - 0.01 * i}, {0, 0, 1});
      view->renderWindow()->Render();
    }
    const double taken = seconds(clock) / turns;
    style->InvokeEvent(vtkCommand::EndInteractionEvent);
    return taken;
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
    const double busy = this->frame();
    QVERIFY(this->Window->bench()->isRunning());
    figure("frame of the demo scene while computing", busy, "s", 0.05);
    SceneView* view = this->Window->view();
    view->look(this->Window->bench()->scene()->cameras().front());
    this->settle();
    QVERIFY(coloured(this->Window->view()->picture()) > before + 1000);
    this->keep("02-running");
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->isRunning(), 120000);
    QVERIFY(this->find<QLabel>("errors")->text().contains("128 trajectories"));
    this->settle();
    const double idle = this->frame();
    figure("frame of the demo scene after it", idle, "s", 0.05);
    figure("frame while computing over that after it", busy / idle, "", 1.5);
    view->look(this->Window->bench()->scene()->cameras().front());
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

  void startsWithItsSceneOrTheDemo()
  {
    this->Window->openFirst(this->furnace());
    QVERIFY(this->Window->windowTitle().startsWith("furnace.json"));
    this->Window->openFirst({});
    QVERIFY(this->Window->windowTitle().startsWith("cornell.json"));
    const auto said = this->answer(QMessageBox::Ok);
    this->Window->openFirst("nowhere.obj");
    QVERIFY(said->contains("no such file"));
    QVERIFY(this->Window->windowTitle().startsWith("cornell.json"));
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

  void keysDoWhatMenusDo()
  {
    this->Window->openFile(demoScene());
    Workbench* bench = this->Window->bench();
    auto press = [this](Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
      QTest::keyClick(this->Window.get(), key, with);
    };
    this->Window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(this->Window.get()));
    this->find<QDoubleSpinBox>("amount")->setValue(1e9);
    press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench->settings().trajectories, MethodSettings().trajectories);
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(bench->settings().trajectories, 1000000000);
    press(Qt::Key_F5);
    QVERIFY(bench->isRunning());
    press(Qt::Key_F6);
    QCOMPARE(bench->activeRun()->state(), Run::State::Paused);
    press(Qt::Key_F6);
    QCOMPARE(bench->activeRun()->state(), Run::State::Running);
    press(Qt::Key_Escape);
    QTRY_VERIFY(!bench->isRunning());
    press(Qt::Key_2, Qt::ControlModifier);
    QVERIFY(this->Window->view()->camera().position != bench->scene()->cameras().front().position);
    press(Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(this->Window->view()->camera().position, bench->scene()->cameras().front().position);
    QCOMPARE(this->Window->view()->camera().fieldOfView, bench->scene()->cameras().front().fieldOfView);
    QStringList keys;
    for (auto* action : this->Window->findChildren<QAction*>())
      if (!action->shortcut().isEmpty())
        keys << action->shortcut().toString();
    QVERIFY2(keys.size() > 12, qPrintable(keys.join(QLatin1Char(' '))));
    QCOMPARE(keys.removeDuplicates(), 0);
  }

  void arrowsTurnTheScene()
  {
    this->Window->openFile(this->furnace());
    SceneView* view = this->Window->view();
    auto distance = [&] { return (view->camera().position - view->camera().target).Norm(); };
    const CameraPreset before = view->camera();
    const double away = distance();
    QTest::keyClick(view, Qt::Key_Left);
    QVERIFY((view->camera().position - before.position).Norm() > 0.05 * away);
    QVERIFY(std::abs(distance() / away - 1) < 1e-9);
    QTest::keyClick(view, Qt::Key_Right);
    QVERIFY((view->camera().position - before.position).Norm() < 1e-9 * away);
    QTest::keyClick(view, Qt::Key_Plus);
    QVERIFY(distance() < 0.95 * away);
  }

  void docksAreRemembered()
  {
    this->find<QDockWidget>("showDock")->close();
    QVERIFY(this->Window->close());
    this->init();
    QVERIFY(!this->find<QDockWidget>("showDock")->isVisible());
    this->find<QDockWidget>("showDock")->toggleViewAction()->trigger();
    QVERIFY(this->find<QDockWidget>("showDock")->isVisible());
    QVERIFY(this->Window->close());
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
