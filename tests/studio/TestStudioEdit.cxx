// SPDX-License-Identifier: BSD-3-Clause
// Edge Studio's scenes that are edited, and the figures and quantities of results.
#include <QJsonArray>
#include <QJsonDocument>

#include "ModelTest.h"
#include "base/DataSets.h"
#include "results/AuditLines.h"
#include "results/Comparison.h"
#include "results/Display.h"
#include "results/Statistics.h"
#include "scene/SceneDraft.h"
#include "session/Workbench.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkKalosArrayNames.h"
#include "vtkStringArray.h"

using namespace studio;

namespace
{
namespace Names = vtkKalosArrayNames;

/// The set "desk" with these illuminances, a standard error of 1 lx each, and the last receiver inside a solid.
ResultPtr resultOf(const ScenePtr& scene, const QVector<double>& values)
{
  const auto shared = scene->receivers({"desk"});
  vtkNew<vtkPolyData> desk;
  desk->ShallowCopy(dataSets(shared).front().data);
  for (const char* name : {Names::Illuminance, Names::IlluminanceStandardError, Names::IntervalTrusted, Names::Valid})
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < desk->GetNumberOfCells(); ++i)
      array->InsertNextValue(name == Names::Illuminance ? values[static_cast<int>(i % values.size())]
                             : name == Names::Valid     ? i + 1 < desk->GetNumberOfCells()
                                                        : 1);
    desk->GetCellData()->AddArray(array);
  }
  vtkNew<vtkMultiBlockDataSet> sets;
  addSet(sets, "desk", desk);
  return std::make_shared<Result>(makeResult({}, sets));
}
}  // namespace

class TestStudioEdit : public ModelTest
{
  Q_OBJECT

private slots:
  void draftsAreEditedAndSaved()
  {
    const QString path = writeFile(this->Folder.path(), "room.json",
                                   R"({"kalos": 1, "materials": {"white": {"reflectance": 0.5}},
      "surfaces": [{"name": "mesh", "file": "mesh.obj", "material": "white"}], "receivers": []})");
    const QJsonObject draft = draftOf(path);
    const DraftPath file{"surfaces", "0", "file"};
    QCOMPARE(valueAt(draft, file).toString(), QDir(this->Folder.path()).absoluteFilePath("mesh.obj"));
    QJsonObject edited = withLuminaire(draft, Point(1, 2, 3));
    edited = withLuminaire(edited, Point(4, 5, 6), "spot.ies");
    edited = withCopy(edited, {"luminaires", "0"});
    const QJsonArray lamps = edited["luminaires"].toArray();
    QCOMPARE(lamps.size(), 3);
    QCOMPARE(lamps[1].toObject()["name"].toString(), QString("lamp 2"));
    QVERIFY(!lamps[1].toObject().contains("flux") && lamps[0].toObject()["flux"] == 1000);
    QCOMPARE(lamps[2].toObject()["position"].toArray(), (QJsonArray{1, 2, 3}));
    edited = withCopy(edited, {"materials", "white"});
    edited = withValue(edited, {"materials", "white 2", "reflectance"}, parsedValue("[0.1, 0.2, 0.3]"));
    QCOMPARE(valueText(valueAt(edited, {"materials", "white 2", "reflectance"})), QString("[0.1,0.2,0.3]"));
    QCOMPARE(withoutEntry(edited, {"materials", "white 2"})["materials"], draft["materials"]);
    QCOMPARE(withoutEntry(edited, {"luminaires", "1"})["luminaires"].toArray().size(), 2);
    QCOMPARE(parsedValue("lambertian"), QJsonValue("lambertian"));
    const double bounds[6] = {0, 4, 1, 3, -1, 2};
    const QJsonValue plane = valueAt(withPlane(draft, bounds), {"receivers", "0", "plane"});
    QCOMPARE(plane["origin"].toArray(), (QJsonArray{0, 1, -0.25}));

    const QString other = QDir(this->Folder.path()).filePath("saved.json");
    saveDraft(draft, other);
    QFile saved(other);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QCOMPARE(valueAt(QJsonDocument::fromJson(saved.readAll()).object(), file).toString(), QString("mesh.obj"));
    QVERIFY(problemOf([] { draftOf("/nowhere/room.json"); }).contains("/nowhere/room.json: file: "));
  }

  void editsSettingsAndDisplayAreUndoneInTheirOrder()
  {
    Workbench bench;
    bench.open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
    const QJsonObject first = bench.draft();
    QVERIFY(!bench.isEdited() && bench.scene()->furnaceIlluminance());
    bench.edit(withLuminaire(first, Point(2, 2, 2)));
    QVERIFY(bench.isEdited() && bench.unsaved() && !bench.hasUnsavedResults());
    QCOMPARE(bench.scene()->luminaires()->GetNumberOfPoints(), 1);
    QVERIFY(!bench.scene()->furnaceIlluminance());
    Display display = bench.display();
    display.isolines = true;
    bench.setDisplay(display);
    bench.setSettings(quick(10));
    bench.undo();
    QVERIFY(bench.settings() != quick(10) && bench.display().isolines);
    bench.undo();
    QVERIFY(!bench.display().isolines && bench.isEdited());
    bench.undo();
    QVERIFY(!bench.isEdited() && !bench.canUndo());
    QCOMPARE(bench.scene()->luminaires()->GetNumberOfPoints(), 0);
    bench.redo();
    QCOMPARE(bench.scene()->luminaires()->GetNumberOfPoints(), 1);
    const QString message = problemOf([&] {
      bench.edit(withValue(bench.draft(), {"luminaires", "0", "flux"}, "bright"));
    });
    QVERIFY2(message.contains("furnace.json: ") && message.contains("flux"), qPrintable(message));
    QCOMPARE(valueAt(bench.draft(), {"luminaires", "0", "flux"}), QJsonValue(1000));
    const QString saved = QDir(this->Folder.path()).filePath("lit.json");
    bench.saveScene(saved);
    QVERIFY(!bench.isEdited());
    QCOMPARE(SceneDocument::open(saved)->luminaires()->GetNumberOfPoints(), 1);
  }

  void statisticsLeaveInvalidPointsOut()
  {
    const ResultPtr result = resultOf(this->furnace(), {100, 200});
    const QVector<SetStatistics> sets = statisticsOf(*result);
    QCOMPARE(sets.size(), 1);
    const SetStatistics& desk = sets.front();
    QCOMPARE(desk.invalid, 1);
    QCOMPARE(result->quality.invalid, 1);
    QCOMPARE(desk.least, 100.0);
    QCOMPARE(desk.largest, 200.0);
    // Cells of one size: one of 200 lx is missing.
    const double n = static_cast<double>(desk.points);
    QVERIFY(std::abs(desk.mean - (150 * (n + 1) - 200) / n) < 1e-9);
    QVERIFY(std::abs(desk.uniformity() - 100 / desk.mean) < 1e-12 && desk.diversity() == 0.5);
    QCOMPARE(desk.meanError, 1.0);
    QVERIFY(!judge(desk, {}));
    QCOMPARE(*judge(desk, {100, 0.5}), Verdict::Pass);
    QCOMPARE(*judge(desk, {100, 0.9}), Verdict::Fail);
    QCOMPARE(*judge(desk, {300, 0}), Verdict::Fail);
    QCOMPARE(*judge(desk, {desk.mean + 1, 0}), Verdict::Undecided);
    QCOMPARE(Requirement::fromJson(Requirement{500, 0.6}.toJson(), "f").uniformity, 0.6);
  }

  void quantitiesHaveArraysAndRanges()
  {
    const ScenePtr scene = this->furnace();
    const ResultPtr result = resultOf(scene, {100, 200});
    vtkDataSet* desk = result->set("desk");
    QCOMPARE(arrayOf(desk, relativeErrorName)->GetComponent(0, 0), 1.0);
    QCOMPARE(arrayOf(desk, untrustedName)->GetComponent(0, 0), 0.0);
    // The desk's nearest edge is that of a wall and the floor or the ceiling, or of two walls.
    const double range[] = {arrayOf(desk, Names::EdgeDistance)->GetRange()[0],
                            arrayOf(desk, Names::EdgeDistance)->GetRange()[1]};
    QVERIFY2(range[0] > 0 && range[1] < scene->size(), qPrintable(QString::number(range[1])));
    Display display;
    display.quantity = Quantity::Untrusted;
    QCOMPARE(rangeOf({result}, display), (std::array<double, 2>{0, 1}));
    QVERIFY(hasQuantity(*result, Quantity::EdgeDistance) && !hasQuantity(*result, Quantity::KernelCorrection));
    vtkNew<vtkDoubleArray> correction;
    correction->SetName(Names::KernelCorrection);
    for (vtkIdType i = 0; i < desk->GetNumberOfCells(); ++i)
      correction->InsertNextValue(-4);
    desk->GetCellData()->AddArray(correction);
    display.quantity = Quantity::KernelCorrection;
    QCOMPARE(rangeOf({result}, display), (std::array<double, 2>{-5, 5}));
    for (Quantity q : quantities())
    {
      display.quantity = q;
      display.colours = "viridis";
      QVERIFY(Display::fromJson(display.toJson(), "f") == display);
    }
  }

  void differencesHaveThreeUnits()
  {
    const ScenePtr scene = this->furnace();
    const Comparison found = compare(*resultOf(scene, {110, 220}), *resultOf(scene, {100, 200}));
    vtkDataSet* desk = dataSets(found.data).front().data;
    QCOMPARE(arrayOf(desk, Comparison::inLux)->GetComponent(1, 0), 20.0);
    QCOMPARE(arrayOf(desk, Comparison::inPercent)->GetComponent(1, 0), 10.0);
    QVERIFY(std::abs(arrayOf(desk, Comparison::inErrors)->GetComponent(1, 0) - 20 / std::sqrt(2.0)) < 1e-12);
    QCOMPARE(colourLimit(found, Comparison::inLux), 20.0);
    QCOMPARE(colourLimit(found, Comparison::inErrors), 5.0);
  }

  void resultsAreRenamedAndRemoved()
  {
    Workbench bench;
    bench.open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
    for (double lux : {100, 200, 300})
      bench.addResult(resultOf(bench.scene(), {lux}));
    bench.show(1);
    bench.rename(1, "evening");
    QCOMPARE(bench.shown()->name, QString("evening"));
    bench.remove(0);
    QCOMPARE(bench.results().size(), 2);
    QCOMPARE(bench.shown()->name, QString("evening"));
    bench.remove(0);
    bench.remove(0);
    QVERIFY(bench.results().isEmpty() && !bench.shown() && !bench.canRemove(0));
  }

  void warningsComeFirstInTheAudit()
  {
    const ScenePtr scene = this->furnace();
    const ResultPtr result = resultOf(scene, {100});
    vtkNew<vtkStringArray> audit;
    audit->SetName(Names::Audit);
    audit->SetNumberOfComponents(3);
    for (const char* text : {"bands", "1", "all materials are photometric", "warning", "a wall leaks", "look at it"})
      audit->InsertNextValue(text);
    result->data->GetFieldData()->AddArray(audit);
    const QVector<AuditLine> lines = auditLines(*scene, result.get());
    QVERIFY(lines.size() >= 2 && lines[0].warning && !lines[1].warning);
    QCOMPARE(lines[0].choice, QString("a wall leaks"));
  }
};

QTEST_GUILESS_MAIN(TestStudioEdit)
#include "TestStudioEdit.moc"
