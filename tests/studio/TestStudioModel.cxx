// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's model without a widget.
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "Colours.h"
#include "DataSets.h"
#include "Helpers.h"
#include "PaintedSurface.h"
#include "Picking.h"
#include "Probe.h"
#include "Problem.h"
#include "ToneMapping.h"
#include "Triangles.h"
#include "Workbench.h"
#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosIlluminance.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

using namespace studio;

class TestStudioModel : public QObject
{
  Q_OBJECT

private:
  QTemporaryDir Folder;
  ScenePtr furnace() { return SceneDocument::open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom())); }
  static MethodSettings quick(qint64 trajectories)
  {
    MethodSettings s;
    s.trajectories = trajectories;
    return s;
  }
  template <class Action>
  static QString problemOf(const Action& action)
  {
    try
    {
      action();
    }
    catch (const Problem& problem)
    {
      return problem.message();
    }
    return {};
  }

private slots:
  void sceneHasItsPartsAndItsEdges()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    QCOMPARE(scene->sets(), (QStringList{"surfaces", "floor", "desk", "walls"}));
    QCOMPARE(scene->usualSets(), (QStringList{"surfaces", "floor", "desk"}));
    QCOMPARE(scene->cameras().size(), 1);
    QCOMPARE(scene->luminaires()->GetNumberOfPoints(), 1);
    QVERIFY(scene->edges()->GetNumberOfCells() > 8);
    QVERIFY(!scene->furnaceIlluminance());
    vtkDataSet* painted = dataSets(scene->receivers({"surfaces"})).front().data;
    QVERIFY2(painted->GetNumberOfCells() > 2000 && painted->GetNumberOfCells() < 8000,
             qPrintable(QString::number(painted->GetNumberOfCells())));
    QVERIFY(painted->GetCellData()->GetNormals() && painted->GetCellData()->HasArray("Reflectance"));
  }

  void furnaceIsKnownAsSuch()
  {
    QCOMPARE(this->furnace()->furnaceIlluminance().value_or(0), 250.0);
    QByteArray open = furnaceRoom();
    open.replace(R"("u": [0,0,2.5], "v": [4,0,0])", R"("u": [0,0,2.4], "v": [4,0,0])");
    QVERIFY(!SceneDocument::open(writeFile(this->Folder.path(), "open.json", open))->furnaceIlluminance());
  }

  void bareMeshBecomesAFurnace()
  {
    const ScenePtr scene = SceneDocument::open(data("sphere/sphere-2.obj"));
    QVERIFY(scene->isBareMesh());
    QCOMPARE(scene->furnaceIlluminance().value_or(0), 200.0);
    QCOMPARE(scene->sets(), QStringList{"surfaces"});
  }

  // Ke is a luminance: 100/pi cd/m2 with a reflectance of 0.5 make a furnace of 200 lx.
  void objBringsItsMaterials()
  {
    writeFile(this->Folder.path(), "cube.mtl", "newmtl glow\nKd 0.5 0.5 0.5\nKe 31.830989 31.830989 31.830989\n");
    const QString path =
        writeFile(this->Folder.path(), "cube.obj",
                  "mtllib cube.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
                  "usemtl glow\nf 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
    const ScenePtr scene = SceneDocument::open(path);
    QVERIFY(!scene->isBareMesh());
    QVERIFY(std::abs(scene->furnaceIlluminance().value_or(0) - 200) < 1e-3);
    QVERIFY2(scene->sets().size() > 1, "a model gets a work plane");
  }

  void gltfBringsItsLights()
  {
    const QString path = writeFile(this->Folder.path(), "floor.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0, 1]}],
      "nodes": [{"mesh": 0}, {"translation": [0.3, 1, -0.3], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
      "buffers": [{"byteLength": 36, "uri":
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIC/"}],
      "extensionsUsed": ["KHR_lights_punctual"],
      "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}}})");
    const ScenePtr scene = SceneDocument::open(path);
    QCOMPARE(scene->luminaires()->GetNumberOfPoints(), 1);
    QVERIFY2(std::abs(scene->luminaires()->GetPoint(0)[2] - 1) < 1e-6, "y is up in glTF");
    QVERIFY(!scene->isBareMesh() && scene->sets().contains("surfaces"));
  }

  void brokenSceneIsRefusedAndTheOldOneStays_data()
  {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    QTest::newRow("no JSON") << QByteArray("{") << QStringLiteral("line 1, column 2: malformed JSON");
    QTest::newRow("unknown key") << QByteArray(furnaceRoom()).replace("\"kalos\"", "\"colour\": 1, \"kalos\"")
                                 << QStringLiteral("colour");
    QTest::newRow("reflectance") << QByteArray(furnaceRoom()).replace("0.6", "1.6")
                                 << QStringLiteral("materials.glow.reflectance: found 1.6");
  }
  void brokenSceneIsRefusedAndTheOldOneStays()
  {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    Workbench bench;
    bench.open(data("cornell/cornell-empty.json"));
    const ScenePtr before = bench.scene();
    const QString path = writeFile(this->Folder.path(), "broken.json", text);
    const QString problem = problemOf([&] { bench.open(path); });
    QVERIFY2(problem.startsWith(path + ": ") && problem.contains(message), qPrintable(problem));
    QCOMPARE(bench.scene(), before);
  }

  void missingMeshIsRefused()
  {
    QCOMPARE(problemOf([] { SceneDocument::open("nowhere.obj"); }),
             QStringLiteral("nowhere.obj: file: no such file; expected a mesh"));
  }

  // 250 lx in the furnace at every receiver; Student with 31 degrees of freedom and Sidak for some 4000 points: |t| <
  // 6.4 has a false-alarm rate of 1e-3.
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
        QVERIFY2(std::abs(lux - 250) < 6.4 * error, qPrintable(QString("%1 ± %2").arg(lux).arg(error)));
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
    QVERIFY2(run.result()->seconds < 1.4, "the pause is not part of the time");
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

  void settingsCanBeUndone()
  {
    Workbench bench;
    const MethodSettings first = bench.settings();
    bench.setSettings(quick(10));
    bench.setSettings(quick(20));
    bench.undo();
    QCOMPARE(bench.settings().trajectories, 10);
    bench.undo();
    QVERIFY(bench.settings() == first && !bench.canUndo());
    bench.redo();
    QVERIFY(bench.canRedo());
    bench.setSettings(quick(30));
    QVERIFY(!bench.canRedo());
    bench.undo();
    QCOMPARE(bench.settings().trajectories, 10);
  }

  void settingsAndDisplayGoThroughJson()
  {
    MethodSettings settings;
    settings.method = vtkKalosIlluminance::SPHERE_EXACT;
    settings.goal = Goal::Error;
    settings.relativeError = 0.025;
    settings.delta = 0.125;
    settings.seed = 77;
    QVERIFY(MethodSettings::fromJson(settings.toJson(), "file") == settings);
    Display display;
    display.quantity = Quantity::StandardError;
    display.scale = Scale::Logarithmic;
    display.range = {0.5, 2000};
    display.hidden = QStringList{"desk"};
    QVERIFY(Display::fromJson(display.toJson(), "file") == display);
  }

  void badJsonIsRefusedWithItsPlace_data()
  {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("value");
    QTest::addColumn<QString>("message");
    QTest::newRow("method")
        << "method" << QJsonValue("magic")
        << "f: settings/method: is \"magic\", expected one of compensated, gathered, local, sphere-exact, "
           "sphere-published, disc, clamped, direct";
    QTest::newRow("delta") << "delta" << QJsonValue(-1)
                           << "f: settings/delta: is -1, expected a number from 0 to 1e+06";
    QTest::newRow("seed") << "seed" << QJsonValue(1.5) << "f: settings/seed: is 1.5, expected a whole number from 0";
  }
  void badJsonIsRefusedWithItsPlace()
  {
    QFETCH(QString, key);
    QFETCH(QJsonValue, value);
    QFETCH(QString, message);
    QJsonObject json = MethodSettings().toJson();
    json[key] = value;
    QCOMPARE(problemOf([&] { MethodSettings::fromJson(json, "f: settings"); }), message);
    json = MethodSettings().toJson();
    json["colour"] = 1;
    QVERIFY(problemOf([&] { MethodSettings::fromJson(json, "f"); }).startsWith("f/colour: unknown, expected one of "));
  }

  void rangeLeavesSpikesOut()
  {
    const ScenePtr scene = this->furnace();
    vtkSmartPointer<vtkMultiBlockDataSet> receivers = scene->receivers({"desk"});
    vtkDataSet* desk = dataSets(receivers).front().data;
    vtkNew<vtkDoubleArray> lux;
    lux->SetName(vtkKalosArrayNames::Illuminance);
    for (int i = 0; i < 1000; ++i)
      lux->InsertNextValue(i < 3 ? 1e6 : 280 + 0.01 * i);
    desk->GetCellData()->AddArray(lux);
    auto result = std::make_shared<Result>();
    result->data = receivers;
    Display display;
    QCOMPARE(rangeOf({result}, display), (std::array<double, 2>{0, 300}));
    display.scale = Scale::Logarithmic;
    QCOMPARE(rangeOf({result}, display), (std::array<double, 2>{0.3, 300}));
    display.hidden = QStringList{"desk"};
    QCOMPARE(rangeOf({result}, display)[1], 1000.0);
  }

  void photographIsExposedForItsAverageAndWhite()
  {
    const Exposure exposure{20, 400};
    QCOMPARE(toneMapped(400, exposure), 1.0);
    // Equation (4) at L = key: 0.18 (1 + 0.18/3.6^2)/1.18.
    QVERIFY(std::abs(toneMapped(20, exposure) - 0.18 * (1 + 0.18 / (3.6 * 3.6)) / 1.18) < 1e-12);
    for (double value = 1; value < 400; value *= 1.5)
    {
      QVERIFY(toneMapped(value, exposure) < toneMapped(1.5 * value, exposure) || value > 260);
      // Grey is the same on both ways.
      const double grey[3] = {value, value, value};
      const int direct = photographicColour(grey, exposure)[0], table = photographicGreys(exposure)->MapValue(value)[0];
      QVERIFY2(std::abs(direct - table) <= 1, qPrintable(QStringLiteral("%1 and %2").arg(direct).arg(table)));
    }
    const double red[3] = {100, 10, 10};
    const auto colour = photographicColour(red, exposure);
    QVERIFY(colour[0] > 2 * colour[1] && colour[1] == colour[2]);
  }

  void largeMeshIsPaintedFromFewPoints()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(240);
    sphere->SetPhiResolution(240);
    sphere->SetRadius(1);
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-5, -5, -1);
    floor->SetPoint1(5, -5, -1);
    floor->SetPoint2(-5, 5, -1);
    vtkNew<vtkAppendPolyData> both;
    both->AddInputConnection(sphere->GetOutputPort());
    both->AddInputConnection(floor->GetOutputPort());
    both->Update();
    const PaintedSurface painted = paintedSurface(both->GetOutput(), 1000);
    vtkPolyData *shape = painted.shape, *receivers = painted.receivers;
    QVERIFY(shape->GetNumberOfCells() > 100000);
    QVERIFY(receivers->GetNumberOfCells() > 300 && receivers->GetNumberOfCells() <= 4000);
    QCOMPARE(painted.standIns->GetNumberOfIds(), shape->GetNumberOfCells());
    vtkIdType ofFloor = 0;
    for (vtkIdType i = 0; i < shape->GetNumberOfCells(); ++i)
    {
      const vtkIdType r = painted.standIns->GetId(i);
      QVERIFY(r >= 0 && r < receivers->GetNumberOfCells());
      QCOMPARE(facing(shape->GetCellData()->GetNormals(), i), facing(receivers->GetCellData()->GetNormals(), r));
      double a[3], b[3];
      cellCentre(shape, i, a);
      cellCentre(receivers, r, b);
      QVERIFY(std::sqrt(vtkMath::Distance2BetweenPoints(a, b)) < 1.5);
    }
    for (vtkIdType r = 0; r < receivers->GetNumberOfCells(); ++r)
    {
      double at[3];
      cellCentre(receivers, r, at);
      ofFloor += at[2] < -0.9999;
    }
    QVERIFY2(ofFloor > 100, "the floor was two triangles");
  }

  void roundValuesAreRound()
  {
    QCOMPARE(roundValues({0, 300}, false, 6), (QVector<double>{0, 50, 100, 150, 200, 250, 300}));
    QCOMPARE(roundValues({0.3, 300}, true, 5), (QVector<double>{1, 10, 100}));
    QCOMPARE(roundValues({30, 300}, true, 10), (QVector<double>{50, 100, 200}));
    QCOMPARE(roundValues({150, 350}, true, 10), (QVector<double>{150, 200, 250, 300, 350}));
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
};

QTEST_GUILESS_MAIN(TestStudioModel)
#include "TestStudioModel.moc"
