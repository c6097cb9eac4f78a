// SPDX-License-Identifier: BSD-3-Clause
// The edge lens in the real window: edges in order, the view at the chosen one, heat maps of every method's error.
#include <QListWidget>
#include <QSlider>
#include <QTabWidget>

#include "WindowTest.h"
#include "panels/LensPanel.h"
#include "vtkKalosEstimatorAlgorithm.h"

using namespace studio;

class TestStudioLens : public WindowTest
{
  Q_OBJECT

  /// Mean of the absolute relative error in the columns of a range.
  static double meanError(const EdgeLens& lens, int method, int from, int to)
  {
    const QVector<double> errors = lens.errors(method);
    double sum = 0;
    int count = 0;
    for (int face = 0; face < 2; ++face)
      for (int row = 0; row < LensGrid::rows; ++row)
        for (int column = from; column < to; ++column)
          if (const int point = lens.grid()->at(face, row, column); point >= 0)
          {
            sum += std::abs(errors[point]);
            ++count;
          }
    return sum / count;
  }

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

  void edgesOfARoomAreWholeAndInOrder()
  {
    QVERIFY(this->Window->openFile(this->furnace()));
    const ScenePtr scene = this->Window->bench()->scene();
    const QVector<EdgePiece> pieces = edgePieces(*scene);
    QCOMPARE(pieces.size(), 12);
    for (int i = 0; i < 12; ++i)
      QVERIFY(std::abs(pieces[i].length() - (i < 4 ? 4 : i < 8 ? 3 : 2.5)) < 1e-6);
    for (const EdgePiece& piece : pieces)
    {
      const auto flanks = flanksOf(*scene, piece);
      QVERIFY(flanks);
      const Point inside = Point(2, 1.5, 1.25) - piece.middle();
      for (const Flank& flank : *flanks)
        QVERIFY2(flank.away.Dot(inside) > 0 && std::abs(flank.away.Dot(flank.normal)) < 1e-9, "into the room");
      QVERIFY(std::abs((*flanks)[0].normal.Dot((*flanks)[1].normal)) < 1e-9);
    }
  }

  void edgeInPiecesIsOneEdge()
  {
    QByteArray room = furnaceRoom();
    for (const char* quad : {R"("quad": {"origin": [0,0,0], "u": [4,0,0], "v": [0,3,0]}, "material": "glow"},)",
                             R"("quad": {"origin": [0,0,0], "u": [0,0,2.5], "v": [4,0,0]}, "material": "glow"},)"})
      room.replace(quad, QByteArray(quad).replace("[4,0,0]", "[2,0,0]") + QByteArray("{\"name\": \"half ") +
                             QByteArray::number(room.size()) + "\", " +
                             QByteArray(quad).replace("[4,0,0]", "[2,0,0]").replace("[0,0,0]", "[2,0,0]"));
    const QVector<EdgePiece> pieces =
        edgePieces(*SceneDocument::open(writeFile(this->Folder.path(), "halves.json", room)));
    QVERIFY(!pieces.isEmpty());
    for (int i = 0; i < 2; ++i)
      QVERIFY2(std::abs(pieces[i].length() - 4) < 1e-6, qPrintable(QString::number(pieces[i].length())));
    QCOMPARE(pieces.size(), 12);
  }

  void contactHasTheFloorOutsideOfTheBox()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    int contacts = 0;
    for (const EdgePiece& piece : edgePieces(*scene))
      if (const auto flanks = piece.contact ? flanksOf(*scene, piece) : std::nullopt)
      {
        ++contacts;
        QVERIFY((*flanks)[0].away.Dot((*flanks)[1].normal) > 0.99);
        QVERIFY((*flanks)[1].away.Dot((*flanks)[0].normal) > 0.99);
      }
    QCOMPARE(contacts, 8);
  }

  void lensShowsWhereMethodsFail()
  {
    QVERIFY(this->Window->openFile(this->furnace()));
    this->find<QTabWidget>("tabs")->setCurrentIndex(5);
    QVERIFY(!this->find<QPushButton>("lensMeasure")->isEnabled());
    const CameraPreset before = this->Window->view()->camera();
    auto* edges = this->find<QListWidget>("lensEdges");
    QVERIFY(edges->item(0)->text().startsWith("Edge of 90°, 4.00 m long"));
    edges->setCurrentRow(0);
    auto* panel = this->Window->findChild<LensPanel*>();
    QVERIFY(this->Window->view()->camera().position != before.position);
    this->find<QSlider>("lensEffort")->setValue(9);
    this->click("lensMeasure");
    QCOMPARE(panel->lens().grid()->points.size(), 2 * LensGrid::rows * LensGrid::columns);
    QTRY_VERIFY_WITH_TIMEOUT(!panel->lens().active(), 200000);
    using Estimator = vtkKalosEstimatorAlgorithm;
    const double local = meanError(panel->lens(), Estimator::LOCAL, 0, 10),
                 compensated = meanError(panel->lens(), Estimator::COMPENSATED, 0, 10),
                 localAway = meanError(panel->lens(), Estimator::LOCAL, 35, 41);
    QVERIFY2(local > 0.1 && compensated < 0.3 * local && localAway < 0.5 * local,
             qPrintable(QStringLiteral("%1 %2 %3").arg(local).arg(compensated).arg(localAway)));
    const QImage map = this->Window->findChild<LensView*>()->heatMap(Estimator::LOCAL);
    QCOMPARE(map.size(), QSize(2 * LensGrid::columns, LensGrid::rows));
    this->keep("24-lens-furnace");
  }

  // What the README shows: the edge between floor and back wall, in a room that is lit.
  void lensOfTheDemoScene()
  {
    QVERIFY(this->Window->openFile(demoScene()));
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({SceneDocument::paintedName()});
    MethodSettings settings;
    settings.trajectories = 2048;
    bench->setSettings(settings);
    bench->run();
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning(), 100000);
    this->find<QTabWidget>("tabs")->setCurrentIndex(5);
    auto* edges = this->find<QListWidget>("lensEdges");
    const QVector<EdgePiece> pieces = edgePieces(*bench->scene());
    for (int row = 0; row < edges->count(); ++row)
      if (const Point middle = pieces[row].middle(); middle[1] > 4.9 && middle[2] < 0.1)
        edges->setCurrentRow(row);
    QVERIFY(edges->currentRow() >= 0);
    this->find<QSlider>("lensEffort")->setValue(9);
    this->click("lensMeasure");
    auto* panel = this->Window->findChild<LensPanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!panel->lens().active(), 200000);
    QVERIFY(!panel->lens().errors(vtkKalosEstimatorAlgorithm::CLAMPED).isEmpty());
    this->keep("25-lens");
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioLens>(argc, argv);
}

#include "TestStudioLens.moc"
