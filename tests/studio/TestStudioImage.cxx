// SPDX-License-Identifier: BSD-3-Clause
// What depends on where one looks from: the image of luminance with gloss, its photograph, its EXR.
#include <QComboBox>
#include <QTabWidget>

#include "WindowTest.h"
#include "base/Problem.h"
#include "panels/ImagePanel.h"
#include "results/Export.h"
#include "results/ToneMapping.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkKalosEXRReader.h"
#include "vtkPointData.h"

using namespace studio;

class TestStudioImage : public WindowTest
{
  Q_OBJECT

private:
  void choose(const char* box, int index)
  {
    this->find<QComboBox>(box)->setCurrentIndex(index);
    emit this->find<QComboBox>(box)->activated(index);
    this->settle();
  }

private slots:
  void init() { this->open(); }
  void cleanup() { this->Window.reset(); }

  void imageHasGlossAndGoesToExr()
  {
    QVERIFY(this->Window->openFile(data("cornell/cornell-mixed.json")));
    this->settle();
    this->find<QTabWidget>("centre")->setCurrentIndex(1);
    this->keep("14-image-empty");
    MethodSettings settings;
    settings.trajectories = 32;
    this->Window->bench()->setSettings(settings);
    this->choose("quantity", 2);
    this->choose("imageRows", 0);
    this->click("computeImage");
    auto* panel = this->Window->findChild<ImagePanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->bench()->image().active(), 120000);
    const ResultPtr result = this->Window->bench()->image().result();
    QVERIFY(result && result->complete && result->trajectories == 32);
    vtkImageData* image = this->Window->bench()->image().data();
    QCOMPARE(image->GetDimensions()[1], 128);
    // Low in the middle, where the side of a box that the lamp does not reach fills the view.
    const vtkIdType floor =
        128 * 18 / 100 * static_cast<vtkIdType>(image->GetDimensions()[0]) + image->GetDimensions()[0] / 2;
    const double luminance = image->GetPointData()->GetArray("Luminance")->GetComponent(floor, 0);
    QVERIFY2(luminance > 0.5 && luminance < 40, qPrintable(QString::number(luminance)));
    this->keep("15-image");
    auto* view = this->find<ImageView>("imageView");
    QTest::mouseMove(view, view->rect().center() - QPoint(3, 3));
    QTest::mouseMove(view, view->rect().center());
    QTRY_VERIFY(this->find<QLabel>("imagePixel")->text().contains(" ± "));

    // The photograph keeps the hue: the left wall is red, the right one green.
    this->choose("scale", 2);
    const QImage photograph = panel->picture();
    int red = 0, green = 0;
    for (int y = 0; y < photograph.height(); ++y)
      for (int x = 0; x < photograph.width(); ++x)
      {
        const QColor c = photograph.pixelColor(x, y);
        red += c.red() > c.green() + 40;
        green += c.green() > c.red() + 20;
      }
    QVERIFY2(red > 200 && green > 200, qPrintable(QStringLiteral("%1 red, %2 green").arg(red).arg(green)));
    this->keep("16-photograph");

    const QString path = this->Folder.filePath("image.exr");
    exportImage(*result, path);
    vtkNew<vtkKalosEXRReader> reader;
    reader->SetFileName(path.toUtf8().constData());
    reader->Update();
    vtkPointData* read = reader->GetOutput()->GetPointData();
    QCOMPARE(reader->GetOutput()->GetDimensions()[0], image->GetDimensions()[0]);
    QCOMPARE(read->GetArray("LuminanceBands")->GetNumberOfComponents(), 3);
    QVERIFY(std::abs(read->GetArray("Luminance")->GetComponent(floor, 0) - luminance) < 1e-5 * luminance);
    QVERIFY(read->HasArray("LuminanceStandardError"));
    QVERIFY_EXCEPTION_THROWN(exportImage(*result, "/nowhere/image.exr"), Problem);
  }

  void sceneIsAPhotographToo()
  {
    QVERIFY(this->Window->openFile(data("cornell/cornell-mixed.json")));
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"surfaces"});
    MethodSettings settings;
    settings.trajectories = 64;
    bench->setSettings(settings);
    this->choose("quantity", 2);
    this->choose("scale", 2);
    this->click("run");
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->shown() && bench->shown()->complete, 120000);
    this->settle();
    const QImage picture = this->Window->view()->picture();
    int red = 0, green = 0;
    for (int y = 0; y < picture.height(); y += 2)
      for (int x = 0; x < picture.width(); x += 2)
      {
        const QColor c = picture.pixelColor(x, y);
        red += c.red() > c.green() + 40 && c.blue() < c.red() - 40;
        green += c.green() > c.red() + 20 && c.green() > c.blue() + 20;
      }
    QVERIFY2(red > 500 && green > 500, qPrintable(QStringLiteral("%1 red, %2 green").arg(red).arg(green)));
    this->keep("17-scene-photograph");
  }

  void imageIsGivenUpWithItsScene()
  {
    QVERIFY(this->Window->openFile(data("cornell/cornell-mixed.json")));
    MethodSettings settings;
    settings.trajectories = 100000000;
    this->Window->bench()->setSettings(settings);
    this->find<QTabWidget>("centre")->setCurrentIndex(1);
    this->click("computeImage");
    QTRY_VERIFY_WITH_TIMEOUT(this->Window->bench()->image().result(), 30000);
    auto said = this->answer(QMessageBox::No);
    QVERIFY(!this->Window->close());
    QVERIFY(said->startsWith("A run is under way."));
    QVERIFY(this->Window->openFile(this->furnace()));
    QVERIFY(!this->Window->bench()->image().active() && !this->Window->bench()->image().result());
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioImage>(argc, argv);
}

#include "TestStudioImage.moc"
