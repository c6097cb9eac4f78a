// SPDX-License-Identifier: BSD-3-Clause
// The real window on a virtual screen: open, run, pause, cancel, bad input, drag and drop.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>

#include "Application.h"
#include "Helpers.h"
#include "MainWindow.h"
#include "ProbePanel.h"
#include "Problem.h"
#include "RecentFiles.h"

using namespace studio;

class TestStudioWindow : public QObject
{
  Q_OBJECT

private:
  QTemporaryDir Folder;
  std::unique_ptr<MainWindow> Window;

  template <class Widget>
  Widget* find(const char* name)
  {
    auto* widget = this->Window->findChild<Widget*>(name);
    if (!widget)
      qFatal("no widget %s", name);
    return widget;
  }
  QString furnace() { return writeFile(this->Folder.path(), "furnace.json", furnaceRoom()); }
  void click(const char* name) { QTest::mouseClick(this->find<QPushButton>(name), Qt::LeftButton); }
  void settle()
  {
    QTest::qWait(150);
    QApplication::processEvents();
  }
  void keep(const QString& name)
  {
    this->settle();
    QVERIFY(this->Window->grab().save(QStringLiteral(KALOS_SCREENSHOTS "/%1.png").arg(name)));
  }
  /// Answers the next dialog and returns what it said.
  std::shared_ptr<QString> answer(QMessageBox::StandardButton button)
  {
    auto said = std::make_shared<QString>();
    auto* timer = new QTimer(this->Window.get());
    connect(timer, &QTimer::timeout, this, [=] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box)
        return;
      *said = box->text() + QLatin1Char('\n') + box->informativeText();
      timer->deleteLater();
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
    timer->start(20);
    return said;
  }
  static int coloured(const QImage& image)
  {
    int count = 0;
    for (int y = 0; y < image.height(); y += 4)
      for (int x = 0; x < image.width(); x += 4)
        count += image.pixelColor(x, y).saturation() > 120;
    return count;
  }

private slots:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init()
  {
    this->Window = std::make_unique<MainWindow>();
    this->Window->show();
    QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
  }
  void cleanup() { this->Window.reset(); }

  void showsTheDemoScene()
  {
    QVERIFY(this->Window->openFile(demoScene()));
    QVERIFY(this->Window->windowTitle().startsWith("cornell.json"));
    this->keep("01-open");
  }

  void runsAndRefines()
  {
    this->Window->openFile(demoScene());
    this->settle();
    const int before = coloured(this->Window->view()->picture());
    this->find<QDoubleSpinBox>("amount")->setValue(512);
    QElapsedTimer clock;
    clock.start();
    this->click("run");
    QTRY_VERIFY_WITH_TIMEOUT(this->Window->bench()->shown(), 20000);
    qInfo("first colours after %lld ms", clock.elapsed());
    QVERIFY(this->find<QPushButton>("cancel")->isEnabled());
    this->settle();
    QVERIFY(coloured(this->Window->view()->picture()) > before + 1000);
    this->keep("02-running");
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->isRunning(), 120000);
    QVERIFY(this->find<QLabel>("errors")->text().contains("512 trajectories"));
    this->keep("03-finished");
    this->find<QCheckBox>("isolines")->click();
    this->find<QComboBox>("scale")->setCurrentIndex(1);
    emit this->find<QComboBox>("scale")->activated(1);
    QVERIFY(this->Window->bench()->display().isolines && this->Window->bench()->display().logarithmic);
    this->keep("04-isolines");
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
    this->click("cancel");
    QTRY_VERIFY(!this->Window->bench()->isRunning());
    QVERIFY(this->find<QLabel>("times")->text().contains("cancelled"));
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
  prepareApplication();
  QApplication application(argc, argv);
  dressApplication();
  TestStudioWindow test;
  return QTest::qExec(&test, argc, argv);
}

#include "TestStudioWindow.moc"
