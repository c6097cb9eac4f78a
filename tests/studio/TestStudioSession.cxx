// SPDX-License-Identifier: BSD-3-Clause
// What the real window writes: sessions that reopen, pictures, values.
#include <QComboBox>
#include <QLineEdit>
#include <QTableWidget>

#include "WindowTest.h"
#include "base/Problem.h"
#include "results/Export.h"
#include "session/Session.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

using namespace studio;

class TestStudioSession : public WindowTest
{
  Q_OBJECT

  // Starts 64 trajectories at the desk of the open scene.
  MethodSettings runDesk()
  {
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = 64;
    bench->setSettings(settings);
    this->click("run");
    return settings;
  }

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

  void sessionReopens()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    Display display;
    display.scale = Scale::Logarithmic;
    bench->setDisplay(display);
    const MethodSettings settings = this->runDesk();
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

  void studyReopens()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    bench->runStudy({bench->settings(), {32, 64}, {0}, {0.125, 0}});
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->results().size() == 4, 30000);
    const QString path = this->Folder.filePath("study.json");
    saveSession(*bench, this->Window->view()->camera(), path);
    this->cleanup();
    this->init();
    QVERIFY(this->Window->openFile(path));
    auto* grid = this->find<QTableWidget>("studyGrid");
    QCOMPARE(grid->rowCount(), 2);
    for (int cell = 0; cell < 4; ++cell)
      QTRY_VERIFY(grid->item(cell / 2, cell % 2) && !grid->item(cell / 2, cell % 2)->icon().isNull());
    QCOMPARE(this->find<QLineEdit>("studyTrajectories")->text(), QStringLiteral("32, 64"));
    QCOMPARE(this->find<QLineEdit>("studyEpsilons")->text(), QStringLiteral("0.125, auto"));
  }

  void imageReopens()
  {
    this->Window->openFile(this->furnace());
    CameraImage* image = &this->Window->bench()->image();
    MethodSettings settings;
    settings.trajectories = 64;
    const ImageRequest request{{"", {3.4, 0.5, 2.1}, {0.8, 1.8, 0.2}, {0, 0, 1}, 70}, 90, 128, settings};
    image->start(this->Window->bench()->scene(), request);
    QTRY_VERIFY_WITH_TIMEOUT(!image->active() && image->result() && image->result()->complete, 60000);
    QTRY_VERIFY2(QFileInfo(autosavePath()).isFile(), "a crash now would leave it");
    const QString path = this->Folder.filePath("image.json");
    saveSession(*this->Window->bench(), this->Window->view()->camera(), path);
    auto middle = [&] { return image->data()->GetPointData()->GetArray("Luminance")->GetComponent(64 * 90 + 45, 0); };
    const double luminance = middle();
    this->cleanup();
    this->init();
    QVERIFY(this->Window->openFile(path));
    image = &this->Window->bench()->image();
    QVERIFY2(image->result() && !image->active(), "it was read, not computed");
    QCOMPARE(image->request()->toJson(), request.toJson());
    QCOMPARE(image->result()->trajectories, 64);
    QCOMPARE(middle(), luminance);
    QCOMPARE(this->find<QComboBox>("imageRows")->currentData().toInt(), 128);
    QVERIFY(this->find<QLabel>("imageAbout")->text().contains("standard error"));
    QVERIFY(this->find<QPushButton>("saveImage")->isEnabled());

    // Without its file it is computed anew: the same numbers.
    QVERIFY(QFile::remove(this->Folder.filePath("image.results/image.vti")));
    QVERIFY(this->Window->openFile(path));
    QVERIFY(image->active());
    QTRY_VERIFY_WITH_TIMEOUT(!image->active() && image->result() && image->result()->complete, 60000);
    QCOMPARE(middle(), luminance);

    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    const QString broken =
        writeFile(this->Folder.path(), "bad-image.json", QByteArray(text).replace("\"height\": 128", "\"height\": 0"));
    const auto said = this->answer(QMessageBox::Ok);
    QVERIFY(!this->Window->openFile(broken));
    QVERIFY2(said->contains("session/image/height"), qPrintable(*said));
  }

  void exportsPictureAndValues()
  {
    this->Window->openFile(this->furnace());
    Workbench* bench = this->Window->bench();
    this->runDesk();
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
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioSession>(argc, argv);
}

#include "TestStudioSession.moc"
