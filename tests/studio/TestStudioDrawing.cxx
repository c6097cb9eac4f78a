// SPDX-License-Identifier: BSD-3-Clause
// What Edge Studio draws into its scenes: luminaires with their photometric solids, edges and contacts by severity.
#include "ModelTest.h"
#include "results/Colours.h"
#include "view/EdgeLines.h"
#include "view/LuminaireGlyphs.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"

using namespace studio;

class TestStudioDrawing : public ModelTest
{
  Q_OBJECT

private:
  ScenePtr lit(const QByteArray& luminaire)
  {
    return SceneDocument::open(writeFile(
        this->Folder.path(), "lit.json",
        QByteArray(furnaceRoom()).replace("\"receivers\"", "\"luminaires\": [" + luminaire + "], \"receivers\"")));
  }

private slots:
  void solidsAreInProportionToIntensity()
  {
    const double lamp[3] = {1, 2, 2.4}, size = 0.5;
    const auto glyphs =
        luminaireGlyphs(this->lit(R"({"name": "lamp", "position": [1, 2, 2.4], "aim": [0, 1, 0], "flux": 100,
                      "distribution": "lambertian"})")
                            ->luminaires(),
                        size);
    double farthest = 0;
    QVERIFY(glyphs->GetNumberOfPoints() > 300);
    for (vtkIdType i = 0; i < glyphs->GetNumberOfPoints(); ++i)
    {
      double to[3];
      vtkMath::Subtract(glyphs->GetPoint(i), lamp, to);
      const double r = vtkMath::Norm(to);
      QVERIFY(r < 1e-12 || std::abs(r - size * to[1] / r) < 1e-9);  // the cosine to the aim
      farthest = std::max(farthest, r);
    }
    QVERIFY(std::abs(farthest - size) < 1e-9);
  }

  void solidOfAFileHasItsCurves()
  {
    const double size = 0.5;
    const ScenePtr scene = this->lit(R"({"name": "lamp", "position": [1, 2, 2.4], "aim": [0, 0, -1], "file": ")" +
                                     data("photometry/pendant.ldt").toUtf8() + R"("})");
    const auto glyphs = luminaireGlyphs(scene->luminaires(), size);
    vtkDataArray* table = scene->luminaires()->GetFieldData()->GetArray("CandelaTable0");
    QVERIFY(table);
    QCOMPARE(glyphs->GetNumberOfPoints(), table->GetNumberOfTuples() + 5);  // and the outline of the opening
    const double lamp[3] = {1, 2, 2.4};
    for (vtkIdType i = 0; i < table->GetNumberOfTuples(); ++i)
    {
      double to[3];
      vtkMath::Subtract(glyphs->GetPoint(i), lamp, to);
      QVERIFY(std::abs(vtkMath::Norm(to) - size * table->GetComponent(i, 2) / table->GetRange(2)[1]) < 1e-9);
      QVERIFY(std::abs(-to[2] - vtkMath::Norm(to) * std::cos(table->GetComponent(i, 1) * M_PI / 180)) < 1e-9);
    }
  }

  void narrowEdgesStandOut()
  {
    const ScenePtr scene = SceneDocument::open(data("furnace/angles.json"));
    const EdgeLines lines = edgeLines(scene->edges(), 0.01);
    vtkDataArray* severity = lines.edges->GetCellData()->GetArray("Severity");
    QVERIFY(severity && severity->GetNumberOfTuples() == lines.edges->GetNumberOfCells());
    QVERIFY2(severity->GetRange()[1] > 20 * severity->GetRange()[0], "from 5 to 170 degrees");
    double narrow[3], wide[3];
    severityColours()->GetColor(severity->GetRange()[1], narrow);
    severityColours()->GetColor(severity->GetRange()[0], wide);
    QVERIFY(vtkMath::Norm(narrow) > 1.2 * vtkMath::Norm(wide));
  }

  void contactsAreDashed()
  {
    const ScenePtr scene = SceneDocument::open(data("cornell/cornell.json"));
    const EdgeLines lines = edgeLines(scene->edges(), 0.05);
    QVERIFY(lines.contacts->GetNumberOfCells() > 60);  // eight sides of 1.5 m stand on the floor
    for (vtkIdType i = 0; i < lines.contacts->GetNumberOfCells(); ++i)
    {
      const double length = std::sqrt(lines.contacts->GetCell(i)->GetLength2());
      QVERIFY2(length > 0.03 && length < 0.08, qPrintable(QString::number(length)));
    }
  }
};

QTEST_GUILESS_MAIN(TestStudioDrawing)
#include "TestStudioDrawing.moc"
