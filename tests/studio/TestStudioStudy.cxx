// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's study, without a widget: its cells, what they are measured against, its runs and its JSON.
#include <QJsonArray>

#include "ModelTest.h"
#include "base/DataSets.h"
#include "session/Workbench.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkKalosArrayNames.h"
#include "vtkKalosIlluminance.h"

using namespace studio;

class TestStudioStudy : public ModelTest
{
  Q_OBJECT

private:
  static Study study()
  {
    Study study;
    study.base.method = vtkKalosIlluminance::SPHERE_EXACT;
    study.base.seed = 5;
    study.trajectories = {64, 256};
    study.deltas = {0, 0.25};
    study.epsilons = {0.125, 0.5, 0};
    return study;
  }
  /// A complete result on the desk of the furnace, of one value but for an addition at the first receiver.
  ResultPtr made(const MethodSettings& settings, double lux, double more = 0)
  {
    const auto receivers = this->furnace()->receivers({"desk"});
    vtkNew<vtkDoubleArray> values;
    values->SetName(vtkKalosArrayNames::Illuminance);
    for (int i = 0; i < 48; ++i)
      values->InsertNextValue(lux + (i == 0 ? more : 0));
    dataSets(receivers).front().data->GetCellData()->AddArray(values);
    auto result = std::make_shared<Result>();
    result->settings = settings;
    result->data = receivers;
    result->trajectories = settings.trajectories;
    result->complete = true;
    return result;
  }

private slots:
  void rowsAreTrajectoriesAndColumnsNeighbourhoods()
  {
    const Study study = this->study();
    QCOMPARE(study.rows(), 2);
    QCOMPARE(study.columns(), 6);
    const MethodSettings cell = study.at(1, 4);
    QCOMPARE(cell.method, static_cast<int>(vtkKalosIlluminance::SPHERE_EXACT));
    QCOMPARE(cell.seed, 5);
    QCOMPARE(cell.trajectories, 256);
    QCOMPARE(cell.delta, 0.25);
    QCOMPARE(cell.epsilon, 0.5);
    QCOMPARE(study.rowName(1), QStringLiteral("N = 256"));
    QCOMPARE(study.columnName(2), QStringLiteral("δ auto\nε auto"));
  }

  void referenceRunsFirstWhereNoneIsAsGood()
  {
    const Study study = this->study();
    QCOMPARE(study.series(*this->furnace(), {}).size(), 12);  // the truth is known
    const ScenePtr room = SceneDocument::open(data("cornell/cornell-empty.json"));
    const QVector<MethodSettings> series = study.series(*room, {});
    QCOMPARE(series.size(), 13);
    QCOMPARE(series.front().method, static_cast<int>(vtkKalosIlluminance::COMPENSATED));
    QCOMPARE(series.front().trajectories, 8 * 256);
    QVERIFY2(series.front().seed != study.base.seed, "errors of the reference are independent");
    QVERIFY(series[1] == study.at(0, 0) && series.last() == study.at(1, 5));
    QCOMPARE(study.series(*room, {this->made(quick(2047), 250)}).size(), 13);
    QCOMPARE(study.series(*room, {this->made(quick(2048), 250)}).size(), 12);
  }

  void cellsAreTheNewestOfTheirSettings()
  {
    const Study study = this->study();
    const ResultPtr old = this->made(study.at(0, 1), 1), other = this->made(quick(9), 2),
                    newer = this->made(study.at(0, 1), 3);
    const QVector<ResultPtr> cells = study.cells({old, newer, other});
    QCOMPARE(cells.size(), 12);
    QCOMPARE(cells[1], newer);
    QCOMPARE(cells.count(nullptr), 11);
  }

  void errorAndBiasAreAgainstTheReference()
  {
    const ScenePtr room = SceneDocument::open(data("cornell/cornell-empty.json"));
    const ResultPtr coarse = this->made(quick(64), 300), fine = this->made(quick(4096), 200),
                    cell = this->made(this->study().at(0, 0), 210, 48);
    QCOMPARE(referenceOf(*room, {cell}).describe(), QString());
    const Reference reference = referenceOf(*room, {fine, coarse, cell});
    QCOMPARE(reference.result, fine);
    const Deviation off = deviationFrom(reference, cell).value_or(Deviation());
    QVERIFY(std::abs(off.bias - 11.0 / 200) < 1e-12);  // 47 receivers 10 lx high and one 58 lx
    QVERIFY(std::abs(off.typical - std::sqrt((47 * 100 + 58 * 58) / 48.0) / 200) < 1e-12);
    QVERIFY2(!deviationFrom(reference, fine), "a reference is not measured against itself");
    const Reference known = referenceOf(*this->furnace(), {fine});
    QVERIFY(std::abs(deviationFrom(known, fine)->bias + 0.2) < 1e-12);
  }

  void benchRunsItOnOneScale()
  {
    Workbench bench;
    bench.open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
    bench.setChosenSets({"desk"});
    bench.setSettings(quick(32));
    bench.run();
    QTRY_VERIFY(!bench.isRunning() && bench.shown() && bench.shown()->complete);
    QCOMPARE(bench.onOneScale(), QVector<ResultPtr>{bench.shown()});
    Study study = this->study();
    study.deltas = {0};
    bench.runStudy(study);
    QTRY_VERIFY_WITH_TIMEOUT(!bench.isRunning() && bench.results().size() == 7, 30000);
    QTRY_VERIFY(bench.shown()->complete);
    QCOMPARE(study.cells(bench.results()), bench.results().mid(1));
    QCOMPARE(bench.onOneScale(), bench.results().mid(1));
    bench.show(0);
    QCOMPARE(bench.onOneScale(), bench.results().mid(0, 1));
    bench.open(data("cornell/cornell-empty.json"));
    QVERIFY(!bench.study());
  }

  void goesThroughJson()
  {
    const Study study = this->study(), again = Study::fromJson(study.toJson(), "f");
    QVERIFY(again.base == study.base);
    for (int cell = 0; cell < 12; ++cell)
      QVERIFY(again.at(cell / 6, cell % 6) == study.at(cell / 6, cell % 6));
    QJsonObject json = study.toJson();
    json["delta"] = QJsonArray{0.1, -1};
    QCOMPARE(problemOf([&] { Study::fromJson(json, "f: study"); }),
             QStringLiteral("f: study/delta: is [0.1,-1], expected an array of numbers from 0"));
    json["delta"] = QJsonArray();
    QCOMPARE(problemOf([&] { Study::fromJson(json, "f: study"); }),
             QStringLiteral("f: study/delta: is [], expected an array of numbers from 0"));
  }
};

QTEST_GUILESS_MAIN(TestStudioStudy)
#include "TestStudioStudy.moc"
