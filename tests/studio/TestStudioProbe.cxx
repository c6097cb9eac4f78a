// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's probes, without a widget: which point is picked, the line across an edge, convergence.
#include "ModelTest.h"
#include "probe/Probe.h"
#include "scene/Picking.h"
#include "vtkKalosIlluminance.h"

using namespace studio;

class TestStudioProbe : public ModelTest
{
  Q_OBJECT

private slots:
  void pickFindsWhatIsSeen()
  {
    const ScenePtr scene = this->furnace();
    // From outside: the front wall shows its back and is looked through, the desk is met from above.
    const Picking all(scene, {"surfaces", "desk"}), walls(scene, {"surfaces"});
    const auto desk = all.first({2, -5, 2}, {2, 6, -0.5});
    QVERIFY(desk && desk->set == "desk");
    QVERIFY(std::abs(desk->position[2] - 0.75) < 1e-6 && desk->normal[2] > 0.99);
    const auto back = walls.first({2, -5, 1}, {2, 9, 1});
    QVERIFY(back && back->set == "surfaces");
    QVERIFY(std::abs(back->position[1] - 3) < 1e-6 && back->normal[1] < -0.99);
    QVERIFY(!walls.first({2, -5, 9}, {2, 9, 9}));
  }

  void lineRunsAcrossTheNearestEdge()
  {
    const ScenePtr scene = this->furnace();
    const Pick floor{{0.4, 1.3, 0}, {0, 0, 1}, "surfaces"};
    const auto edge = nearestEdge(*scene, floor.position);
    QVERIFY(edge && !edge->contact);
    QVERIFY(std::abs(edge->distance - 0.4) < 1e-9 && std::abs(edge->angle - 90) < 1e-6);
    const auto line = lineAcrossEdge(scene, floor);
    QVERIFY(line);
    QVERIFY(std::abs(line->distances.front() - 1e-4) < 1e-12);
    QVERIFY2(line->distances.last() > 3 && line->distances.last() < 4, "the opposite wall is 4 m away");
    for (int i = 0; i < line->points.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        QVERIFY(std::abs(line->points[i][axis] - Point{line->distances[i], 1.3, 0}[axis]) < 1e-9);
  }

  void lineEndsWhereItsPlaneEnds()
  {
    const ScenePtr scene = SceneDocument::open(
        writeFile(this->Folder.path(), "half.json",
                  QByteArray(furnaceRoom())
                      .replace(R"("u": [4,0,0], "v": [0,3,0], "res)", R"("u": [2,0,0], "v": [0,3,0], "res)")));
    const auto line = lineAcrossEdge(scene, {{1, 1.5, 0.75}, {0, 0, 1}, "desk"});
    QVERIFY(line);
    QVERIFY2(line->distances.last() > 1.5 && line->distances.last() < 2.01,
             qPrintable(QString::number(line->distances.last())));
  }

  void lineEndsWhereItsSurfaceEnds()
  {
    // The top of a box on the floor of the Cornell room has no singular edge of its own: its side has.
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    const double turn = -17 * M_PI / 180;
    const Pick side{{3.3 - 0.75 * std::cos(turn), 1.7 - 0.75 * std::sin(turn), 0.3},
                    {-std::cos(turn), -std::sin(turn), 0},
                    "surfaces"};
    const auto line = lineAcrossEdge(scene, side);
    QVERIFY(line && line->edge.contact);
    QVERIFY2(line->distances.last() > 1.1 && line->distances.last() < 1.5, "the box is 1.5 m high");
  }

  void probeConvergesAndKnowsSingleTrajectories()
  {
    const ScenePtr scene = this->furnace();
    Probe probe;
    MethodSettings settings = quick(640);
    settings.method = vtkKalosIlluminance::LOCAL;
    probe.start(scene, {{0.001, 1.5, 0}, {0, 0, 1}, "surfaces"}, settings, 32);
    QTRY_VERIFY_WITH_TIMEOUT(!probe.active(), 30000);
    QCOMPARE(probe.trajectories(), 640);
    const Chart convergence = probe.convergence(), histogram = probe.histogram();
    QCOMPARE(convergence.series.last().points.first().y(), 250.0);
    QVERIFY(convergence.series.first().points.size() > 3);
    // 32 batches of 32; those that give no light have no place on the axis and are told apart.
    double single = 0;
    for (const QPointF& bar : histogram.series.first().points)
      single += bar.y();
    const QStringList dark = histogram.series.first().name.split(QStringLiteral(", ")).mid(1);
    QCOMPARE(single + (dark.isEmpty() ? 0 : dark[0].split(QLatin1Char(' '))[0].toInt()), 1024.0);
    // A millimetre from the edge one trajectory outweighs hundreds of others.
    const Series& largest = histogram.series.last();
    QVERIFY(largest.name.startsWith("largest, "));
    const double mean = histogram.series[1].points[0].x();
    QVERIFY2(largest.points[0].x() > 20 * mean, qPrintable(QString::number(largest.points[0].x() / mean)));
    QVERIFY2(!probe.estimate()->trusted, "a millimetre from the edge, plain local estimation is not to be trusted");
  }
};

QTEST_GUILESS_MAIN(TestStudioProbe)
#include "TestStudioProbe.moc"
