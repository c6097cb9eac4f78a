// SPDX-License-Identifier: BSD-3-Clause
// The real window loses nothing unasked, and says what it shows.
#include <QAction>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QStatusBar>

#include "WindowTest.h"
#include "base/Problem.h"
#include "common/SaveDialog.h"
#include "panels/ProbePanel.h"
#include "results/Export.h"
#include "session/Session.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRendererCollection.h"

using namespace studio;

class TestStudioCare : public WindowTest
{
  Q_OBJECT

  QByteArray contents(const QString& path)
  {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  /// Enters a name in the next dialog that asks for a file.
  void nameFile(const QString& path)
  {
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, [=] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog)
        return;
      timer->deleteLater();
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
      QMetaObject::invokeMethod(dialog, "accept");
    });
    timer->start(20);
  }

  void runDesk(qint64 trajectories = 64)
  {
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = trajectories;
    bench->setSettings(settings);
    QTRY_VERIFY(this->find<QPushButton>("run")->isEnabled());  // the run before has ended
    this->click("run");
    QTRY_VERIFY(bench->shown() && (trajectories > 1000000 || (!bench->isRunning() && bench->shown()->complete)));
  }

  QString caption() { return this->Window->view()->findChildren<QLabel*>().front()->text(); }

private slots:
  void init()
  {
    this->open();
    QVERIFY(this->Window->openFile(this->furnace()));
  }
  void cleanup() { this->Window.reset(); }

  void sessionNeverReplacesAScene()
  {
    const QString scene = this->furnace();
    const QByteArray before = this->contents(scene);
    this->nameFile(scene);
    this->Window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(this->Window.get()));
    QTest::keyClick(this->Window.get(), Qt::Key_S, Qt::ControlModifier);
    const QString session = this->Folder.filePath("furnace.kalos-session.json");
    QVERIFY(isSession(session));
    QCOMPARE(this->contents(scene), before);
    try
    {
      saveSession(*this->Window->bench(), this->Window->view()->camera(), scene);
      QFAIL("a scene was replaced");
    }
    catch (const Problem& problem)
    {
      QCOMPARE(problem.message(), scene + ": file: is not a session; expected a new name or that of a session");
    }
    QCOMPARE(this->contents(scene), before);
  }

  void namesGetTheirSuffix_data()
  {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("chosen");
    QTest::addColumn<QString>("expected");
    QTest::newRow("none") << "a/b"
                          << "svg"
                          << "a/b.svg";
    QTest::newRow("another kind") << "a/b.PNG"
                                  << "svg"
                                  << "a/b.PNG";
    QTest::newRow("a dot in the name") << "a/b.1"
                                       << "png"
                                       << "a/b.1.png";
    QTest::newRow("half of it") << "a/room.json"
                                << "kalos-session.json"
                                << "a/room.kalos-session.json";
  }

  void namesGetTheirSuffix()
  {
    QFETCH(QString, path);
    QFETCH(QString, chosen);
    QFETCH(QString, expected);
    const QVector<FileKind> kinds{{"SVG", "svg"}, {"PNG", "png"}, {"Session", "kalos-session.json"}};
    QCOMPARE(withSuffix(path, kinds, {"", chosen}), expected);
  }

  void replacingAsks()
  {
    this->runDesk();
    const QString folder = this->Folder.filePath("values");
    const QStringList paths = exportResult(*this->Window->bench()->shown(), folder);
    QCOMPARE(paths, exportedFiles(*this->Window->bench()->shown(), folder));
    QVERIFY(mayReplace(this->Window.get(), {this->Folder.filePath("new.csv")}));
    auto said = this->answer(QMessageBox::No);
    QVERIFY(!mayReplace(this->Window.get(), paths));
    QVERIFY2(said->startsWith("2 files of these names exist.") && said->contains("desk.csv"), qPrintable(*said));
    this->answer(QMessageBox::Yes);
    QVERIFY(mayReplace(this->Window.get(), paths));
  }

  void anotherSceneAsksForResults()
  {
    this->runDesk();
    const QString other = data("cornell/cornell-empty.json");
    auto said = this->answer(QMessageBox::Cancel);
    QVERIFY(!this->Window->openFile(other));
    QVERIFY2(said->startsWith("The results of furnace.json are not saved."), qPrintable(*said));
    QCOMPARE(this->Window->bench()->results().size(), 1);
    const QString session = this->Folder.filePath("kept.kalos-session.json");
    this->nameFile(session);
    this->answer(QMessageBox::Save);
    QVERIFY(this->Window->openFile(other));
    QVERIFY(isSession(session));
    QVERIFY2(this->Window->openFile(session), "nothing is lost, and nothing asked");
    QCOMPARE(this->Window->bench()->results().size(), 1);
  }

  void cancelledResultsAreSaved()
  {
    this->runDesk(1000000000);
    QTRY_VERIFY(!this->Window->bench()->shown()->preview);
    this->click("cancel");
    QTRY_VERIFY(!this->Window->bench()->isRunning());
    const qint64 trajectories = this->Window->bench()->shown()->trajectories;
    QVERIFY2(isSession(autosavePath()), "a crash now would leave it");
    const QString session = this->Folder.filePath("cancelled.kalos-session.json");
    saveSession(*this->Window->bench(), this->Window->view()->camera(), session);
    this->Window->bench()->markSaved();
    QVERIFY(this->Window->openFile(session));
    QVERIFY(this->Window->bench()->shown() && !this->Window->bench()->shown()->complete);
    QCOMPARE(this->Window->bench()->shown()->trajectories, trajectories);
  }

  void newRunIsShownAndNamed()
  {
    this->runDesk();
    this->runDesk(128);
    this->find<QListWidget>("results")->setCurrentRow(0);
    QCOMPARE(this->Window->bench()->shown()->trajectories, 64);
    QVERIFY2(this->caption().startsWith("compensated · N 64 · seed 1 · error "), qPrintable(this->caption()));
    this->runDesk(256);
    QCOMPARE(this->Window->bench()->shown()->trajectories, 256);
    QVERIFY2(this->caption().contains("N 256"), qPrintable(this->caption()));
    this->keep("20-caption");
  }

  void nothingTickedSaysSo()
  {
    this->Window->bench()->setChosenSets({});
    const auto said = this->answer(QMessageBox::Ok);
    this->click("run");
    QVERIFY2(said->startsWith("There is nothing to compute."), qPrintable(*said));
    QVERIFY(!this->Window->bench()->isRunning());
  }

  void hiddenSetsStayWithTheirScene()
  {
    Display display = this->Window->bench()->display();
    display.hidden = QStringList{"desk"};
    this->Window->bench()->setDisplay(display);
    QVERIFY(this->Window->openFile(data("cornell/cornell.json")));
    QVERIFY(this->Window->bench()->display().hidden.isEmpty());
  }

  void keysOfVtkDoNothing()
  {
    SceneView* view = this->Window->view();
    for (const char key : {'3', 'w', 'f', 'p', 'r'})
      QTest::keyClick(view, key);
    QCOMPARE(view->renderWindow()->GetStereoRender(), 0);
    auto* actors = view->renderWindow()->GetRenderers()->GetFirstRenderer()->GetActors();
    QVERIFY(actors->GetNumberOfItems() > 0);
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
      QCOMPARE(actor->GetProperty()->GetRepresentation(), VTK_SURFACE);
  }

  void outwardMeshIsTurnedOrDark()
  {
    const QString cube = writeFile(this->Folder.path(), "cube.obj",
                                   "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
                                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    auto said = this->answer(QMessageBox::No);
    QVERIFY(this->Window->openFile(cube));
    QVERIFY2(said->startsWith("The fronts of this mesh are outside."), qPrintable(*said));
    QVERIFY(!this->Window->bench()->scene()->furnaceIlluminance());
    QVERIFY(this->Window->statusBar()->currentMessage().endsWith("on its fronts, which are outside"));
    auto* probe = this->Window->findChild<ProbePanel*>();
    probe->probe({{1, 1, 2}, {0, 0, 1}, "surfaces"});
    QTRY_VERIFY_WITH_TIMEOUT(!probe->pointProbe().active(), 30000);
    QCOMPARE(this->find<QLabel>("probeValue")->text(), QStringLiteral("0 lx"));
    QVERIFY(this->find<QLabel>("probePlace")->text().contains("no trajectory has brought light here"));

    this->answer(QMessageBox::Yes);
    QVERIFY(this->Window->openFile(cube));
    QCOMPARE(this->Window->bench()->scene()->furnaceIlluminance().value_or(0), 200.0);
    const QString session = this->Folder.filePath("turned.kalos-session.json");
    saveSession(*this->Window->bench(), this->Window->view()->camera(), session);
    QVERIFY(this->Window->openFile(session));
    QCOMPARE(this->Window->bench()->scene()->furnaceIlluminance().value_or(0), 200.0);
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioCare>(argc, argv);
}

#include "TestStudioCare.moc"
