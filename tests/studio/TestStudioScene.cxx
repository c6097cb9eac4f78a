// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's scenes: what their files bring, what is refused, how large ones are painted.
#include <QSignalSpy>

#include "ModelTest.h"
#include "base/DataSets.h"
#include "scene/PaintedSurface.h"
#include "scene/Triangles.h"
#include "session/Workbench.h"
#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

using namespace studio;

class TestStudioScene : public ModelTest
{
  Q_OBJECT

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
    QVERIFY2(painted->GetNumberOfCells() > 6000 && painted->GetNumberOfCells() < 13000,
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

  // A shade 1.5 m above the floor and a lamp 3 m above it: on the floor the shadow ends at x = 1.6 m, in the middle of
  // cells of 0.5 m.
  void shadowsEndWhereTheyDo()
  {
    const ScenePtr scene = SceneDocument::open(writeFile(this->Folder.path(), "shade.json", R"({"kalos": 1,
      "materials": {"black": {"reflectance": 0}},
      "surfaces": [
        {"name": "floor", "quad": {"origin": [0,0,0], "u": [4,0,0], "v": [0,4,0]}, "material": "black"},
        {"name": "shade", "quad": {"origin": [1,0,1.5], "u": [0.8,0,0], "v": [0,4,0]}, "material": "black"}],
      "luminaires": [{"name": "lamp", "position": [2,2,3], "aim": [0,0,-1], "flux": 1256.6371, "distribution": "isotropic"}],
      "receivers": [
        {"name": "desk", "plane": {"origin": [0,0,0], "u": [4,0,0], "v": [0,4,0], "resolution": [8,8]}}]})"));
    QVERIFY2(!this->furnace()->fineShadows("desk"), "there is no shadow");
    const auto fine = scene->fineShadows("desk");
    QVERIFY(fine);
    Run run(scene, scene->receivers({"desk"}), quick(64));
    QSignalSpy ended(&run, &Run::ended);
    QVERIFY(ended.wait(30000));
    auto* solved = vtkPolyData::SafeDownCast(run.result()->set("desk"));
    QVERIFY(!fine->picture(solved, "IlluminanceStandardError"));
    const auto picture = fine->picture(solved, "Illuminance");
    int lit = 0, dark = 0;
    for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
    {
      const Point at(picture->GetPoint(i));
      const double lux = picture->GetPointData()->GetArray("Illuminance")->GetComponent(i, 0);
      if (std::abs(at[0] - 1.6) > 0.1 || std::abs(at[0] - 1.6) < 0.004)
        continue;
      const double distance = (at - Point(2, 2, 3)).Norm();
      const double expected = at[0] > 1.6 ? 100 * 3 / (distance * distance * distance) : 0;
      QVERIFY2(std::abs(lux - expected) < 0.02,
               qPrintable(QStringLiteral("%1 lx for %2 at x = %3").arg(lux).arg(expected).arg(at[0])));
      ++(expected > 0 ? lit : dark);
    }
    QVERIFY2(lit > 200 && dark > 200, qPrintable(QStringLiteral("%1 and %2").arg(lit).arg(dark)));
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
      QVERIFY((cellCentre(shape, i) - cellCentre(receivers, r)).Norm() < 1.5);
    }
    for (vtkIdType r = 0; r < receivers->GetNumberOfCells(); ++r)
      ofFloor += cellCentre(receivers, r)[2] < -0.9999;
    QVERIFY2(ofFloor > 100, "the floor was two triangles");
  }
};

QTEST_GUILESS_MAIN(TestStudioScene)
#include "TestStudioScene.moc"
