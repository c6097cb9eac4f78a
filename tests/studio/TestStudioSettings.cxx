// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's settings and the way results are shown: undo, JSON, ranges, photographs.
#include "ModelTest.h"
#include "base/DataSets.h"
#include "results/ToneMapping.h"
#include "session/Workbench.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosIlluminance.h"

using namespace studio;

class TestStudioSettings : public ModelTest
{
  Q_OBJECT

private slots:
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
           "sphere-published, disc, clamped, direct, paths, photon-map";
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

  void presetsShowAllOfAScene()
  {
    const double bounds[6] = {1, 5, -2, 1, 0, 2.5};
    for (double shape : {0.5, 1.0, 2.0})
    {
      const CameraPreset camera = fitted(bounds, {0, 0, -1}, {0, 1, 0}, shape);
      QVERIFY(camera.target == Point(3, -0.5, 1.25));
      // From above: what is nearest, 2.5 m high, touches a margin of 6 %.
      const double above = camera.position[2] - 2.5, least = std::tan(17.5 * M_PI / 180);
      const double across = 2 / (above * least * std::max(1.0, shape)),
                   along = 1.5 / (above * least * std::max(1.0, 1 / shape));
      QVERIFY2(std::abs(std::max(across, along) - 1 / 1.06) < 1e-9, qPrintable(QString::number(across)));
      QVERIFY(std::abs(camera.verticalAngle(shape) / 2 * M_PI / 180 - std::atan(least * std::max(1.0, 1 / shape))) <
              1e-12);
    }
    CameraPreset camera{"", {1, 2, 3}, {4, 5, 6}, {0, 1, 0}, 33};
    QCOMPARE(CameraPreset::fromJson(camera.toJson(), "f").toJson(), camera.toJson());
    camera.fieldOfView = 180;
    QCOMPARE(problemOf([&] { CameraPreset::fromJson(camera.toJson(), "f: camera"); }),
             QStringLiteral("f: camera/fov_deg: is 180, expected a number from 0.1 to 179"));
  }

  void roundValuesAreRound()
  {
    QCOMPARE(roundValues({0, 300}, false, 6), (QVector<double>{0, 50, 100, 150, 200, 250, 300}));
    QCOMPARE(roundValues({0.3, 300}, true, 5), (QVector<double>{1, 10, 100}));
    QCOMPARE(roundValues({30, 300}, true, 10), (QVector<double>{50, 100, 200}));
    QCOMPARE(roundValues({150, 350}, true, 10), (QVector<double>{150, 200, 250, 300, 350}));
  }
};

QTEST_GUILESS_MAIN(TestStudioSettings)
#include "TestStudioSettings.moc"
