// SPDX-License-Identifier: BSD-3-Clause
// Editing a scene in the real window, its figures, and what every control says about itself.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSlider>
#include <QTabWidget>
#include <QTableWidget>
#include <QTreeWidget>

#include "WindowTest.h"
#include "scene/SceneDraft.h"
#include "vtkKalosIlluminance.h"

using namespace studio;

class TestStudioEditing : public WindowTest
{
  Q_OBJECT

private:
  QTreeWidgetItem* item(const QStringList& path)
  {
    auto* tree = this->find<QTreeWidget>("draft");
    for (QTreeWidgetItemIterator it(tree); *it; ++it)
      if ((*it)->data(0, Qt::UserRole).toStringList() == path)
        return *it;
    qFatal("no item %s", qPrintable(path.join(QLatin1Char('/'))));
    return nullptr;
  }
  void openTab(int index)
  {
    this->find<QTabWidget>("tabs")->setCurrentIndex(index);
    this->settle();
  }
  void run()
  {
    Workbench* bench = this->Window->bench();
    bench->run();
    QTRY_VERIFY_WITH_TIMEOUT(!bench->isRunning() && bench->shown() && bench->shown()->complete, 60000);
    this->settle();
  }

private slots:
  void cleanup()
  {
    if (this->Window)
      this->Window->bench()->markSaved();
    this->Window.reset();
  }

  void aSceneIsEditedAndUndone()
  {
    this->open();
    QVERIFY(this->Window->openFile(data("cornell/cornell-empty.json")));
    Workbench* bench = this->Window->bench();
    this->openTab(7);
    const CameraPreset camera = this->Window->view()->camera();
    this->item({"luminaires", "0", "flux"})->setText(1, "20000");
    this->settle();
    QCOMPARE(valueAt(bench->draft(), {"luminaires", "0", "flux"}), QJsonValue(20000));
    QVERIFY(this->Window->windowTitle().contains("edited"));
    QVERIFY((this->Window->view()->camera().position - camera.position).Norm() < 1e-9);
    const auto said = this->answer(QMessageBox::Ok);
    this->item({"luminaires", "0", "flux"})->setText(1, "bright");
    QTRY_VERIFY(said->contains("flux"));
    this->settle();
    QCOMPARE(this->item({"luminaires", "0", "flux"})->text(1), QString("20000"));

    this->find<QTreeWidget>("draft")->setCurrentItem(this->item({"luminaires", "0"}));
    this->click("copyEntry");
    QCOMPARE(bench->scene()->luminaires()->GetNumberOfPoints(), 2);
    this->click("addPlane");
    QVERIFY(bench->scene()->sets().contains("plane"));
    this->keep("20-editing");
    this->find<QAction>("undo")->trigger();
    this->find<QAction>("undo")->trigger();
    QCOMPARE(bench->scene()->luminaires()->GetNumberOfPoints(), 1);
    this->find<QAction>("undo")->trigger();
    QVERIFY(!bench->isEdited());
  }

  void figuresAndRequirements()
  {
    this->open();
    QVERIFY(this->Window->openFile(data("cornell/cornell.json")));
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk", "floor"});
    MethodSettings settings;
    settings.method = vtkKalosIlluminance::GATHERED;
    settings.trajectories = 512;
    bench->setSettings(settings);
    Display display = bench->display();
    display.isolines = true;
    display.values = true;
    bench->setDisplay(display);
    this->run();
    this->Window->view()->lookAlong({0, 0, -1}, {0, 1, 0});
    this->openTab(6);
    auto* table = this->find<QTableWidget>("statistics");
    QCOMPARE(table->rowCount(), 2);
    QVERIFY(table->item(0, 0)->text().toDouble() > 50);
    QCOMPARE(table->item(0, 5)->text(), QString());
    bench->require(table->verticalHeaderItem(0)->text(), {20, 0});
    QCOMPARE(table->item(0, 5)->text(), QString("pass"));
    bench->require(table->verticalHeaderItem(0)->text(), {20, 0.99});
    QCOMPARE(table->item(0, 5)->text(), QString("fail"));
    QVERIFY(this->find<QTreeWidget>("audit")->topLevelItemCount() > 3);
    this->keep("21-values");
  }

  void quantitiesAreShown()
  {
    this->open();
    QVERIFY(this->Window->openFile(data("cornell/cornell-empty.json")));
    Workbench* bench = this->Window->bench();
    MethodSettings settings;
    settings.method = vtkKalosIlluminance::CLAMPED;
    settings.trajectories = 256;
    bench->setSettings(settings);
    this->run();
    auto* box = this->find<QComboBox>("quantity");
    QCOMPARE(box->count(), static_cast<int>(quantities().size()));
    Display display = bench->display();
    for (Quantity q : {Quantity::RelativeError, Quantity::EdgeDistance, Quantity::KernelCorrection})
    {
      display.quantity = q;
      bench->setDisplay(display);
      this->keep(QStringLiteral("22-quantity-%1").arg(static_cast<int>(q)));
    }
    QVERIFY2(!(box->model()->flags(box->model()->index(static_cast<int>(Quantity::GatherRays), 0)) & Qt::ItemIsEnabled),
             "clamped sends no gather rays");
  }

  void everyControlHasATip()
  {
    this->open();
    QVERIFY(this->Window->openFile(this->furnace()));
    QStringList bare;
    for (auto* widget : this->Window->findChildren<QWidget*>())
    {
      const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QLineEdit*>(widget) ||
                           qobject_cast<QSlider*>(widget) || qobject_cast<QAbstractItemView*>(widget);
      bool inner = widget->objectName().startsWith("qt_");
      for (const QWidget* above = widget->parentWidget(); above && !inner; above = above->parentWidget())
        inner = qobject_cast<const QComboBox*>(above) || qobject_cast<const QAbstractSpinBox*>(above) ||
                qobject_cast<const QAbstractItemView*>(above) || above->inherits("QTabBar") ||
                above->inherits("QDockWidgetTitleButton");
      if (control && !inner && !widget->inherits("QDockWidgetTitleButton") && widget->toolTip().isEmpty())
        bare << QStringLiteral("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
    }
    QVERIFY2(bare.isEmpty(), qPrintable(bare.join(QLatin1Char('\n'))));
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioEditing>(argc, argv);
}

#include "TestStudioEditing.moc"
