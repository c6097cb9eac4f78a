// SPDX-License-Identifier: BSD-3-Clause
// What the real window says: all of it can be translated, none of it is cut off.
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QTabWidget>
#include <QTranslator>

#include "WindowTest.h"
#include "charts/ChartView.h"

using namespace studio;

namespace
{
/// Puts every text that is given to tr() in brackets.
class Brackets : public QTranslator
{
public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* text, const char*, int) const override
  {
    return QLatin1Char('[') + QString::fromUtf8(text) + QLatin1Char(']');
  }
};
}  // namespace

class TestStudioWords : public WindowTest
{
  Q_OBJECT

private:
  /// Every text of the window but names of methods and of receivers.
  QStringList texts()
  {
    QStringList all{this->Window->windowTitle()};
    for (auto* action : this->Window->findChildren<QAction*>())
      all << action->text();
    for (auto* menu : this->Window->findChildren<QMenu*>())
      all << menu->title();
    for (auto* label : this->Window->findChildren<QLabel*>())
      all << label->text();
    for (auto* button : this->Window->findChildren<QAbstractButton*>())
      all << button->text();
    for (auto* dock : this->Window->findChildren<QDockWidget*>())
      all << dock->windowTitle();
    for (auto* tabs : this->Window->findChildren<QTabWidget*>())
      for (int i = 0; i < tabs->count(); ++i)
        all << tabs->tabText(i);
    for (auto* box : this->Window->findChildren<QComboBox*>())
      for (int i = 0; i < box->count() && box->objectName() != "method" && box->objectName() != "compareWith"; ++i)
        all << box->itemText(i);
    for (auto* chart : this->Window->findChildren<ChartView*>())
      all << chart->chart().title << chart->chart().xLabel << chart->chart().yLabel << chart->chart().empty;
    for (auto* widget : this->Window->findChildren<QWidget*>())
      all << widget->toolTip();
    for (auto* legend : this->Window->findChildren<QWidget*>("legend"))
      all << static_cast<LegendBar*>(legend)->legend().title;
    return all;
  }
  void runDesk()
  {
    QVERIFY(this->Window->openFile(this->furnace()));
    Workbench* bench = this->Window->bench();
    bench->setChosenSets({"desk"});
    MethodSettings settings;
    settings.trajectories = 64;
    bench->setSettings(settings);
    bench->run();
    QTRY_VERIFY(!bench->isRunning() && bench->shown() && bench->shown()->complete);
    this->settle();
  }
  /// Less than what its text needs.
  static bool isCutOff(const QWidget* widget)
  {
    const auto* label = qobject_cast<const QLabel*>(widget);
    if (label && label->wordWrap())
      return label->heightForWidth(label->width()) > label->height();
    if (const auto* edit = widget->findChild<const QLineEdit*>(); edit && qobject_cast<const QAbstractSpinBox*>(widget))
      return edit->fontMetrics().horizontalAdvance(edit->text()) > edit->width() - 4;  // not of the largest number
    return widget->width() < widget->minimumSizeHint().width() || widget->height() < widget->minimumSizeHint().height();
  }
  static QString name(const QWidget* widget)
  {
    const auto* label = qobject_cast<const QLabel*>(widget);
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return QStringLiteral("%1 %2 \"%3\" %4 x %5")
        .arg(widget->metaObject()->className(), widget->objectName(),
             label    ? label->text()
             : button ? button->text()
                      : QString())
        .arg(widget->width())
        .arg(widget->height());
  }

private slots:
  void cleanup() { this->Window.reset(); }

  void everythingCanBeTranslated()
  {
    Brackets brackets;
    QApplication::installTranslator(&brackets);
    this->open();
    this->runDesk();
    QStringList missing;
    const QStringList all = this->texts();
    for (const QString& text : all)
      if (!text.trimmed().isEmpty() && !text.contains(QLatin1Char('[')))
        missing << text;
    QApplication::removeTranslator(&brackets);
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QStringLiteral(" | "))));
    QVERIFY2(all.size() > 100, "the texts were found");
  }

  // In the smallest window; also run at 200 %, see CMakeLists.txt.
  void nothingIsCutOff()
  {
    this->open();
    this->runDesk();
    const QSize least = this->Window->minimumSizeHint();
    QVERIFY2(least.width() <= 1280 && least.height() <= 760,
             qPrintable(QStringLiteral("%1 x %2 do not fit a small screen").arg(least.width()).arg(least.height())));
    this->Window->resize(least);
    QStringList bad;
    for (const char* name : {"centre", "tabs"})
    {
      auto* tabs = this->find<QTabWidget>(name);
      for (int i = 0; i < tabs->count(); ++i)
      {
        tabs->setCurrentIndex(i);
        this->settle();
        for (auto* widget : this->Window->findChildren<QWidget*>())
        {
          const bool says = qobject_cast<QLabel*>(widget) || qobject_cast<QComboBox*>(widget) ||
                            qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QPushButton*>(widget) ||
                            qobject_cast<QCheckBox*>(widget);
          if (says && widget->isVisible() && isCutOff(widget))
            bad << this->name(widget);
        }
      }
      tabs->setCurrentIndex(0);
    }
    this->keep("18-smallest-window");
    bad.removeDuplicates();
    QVERIFY2(bad.isEmpty(), qPrintable(bad.join(QLatin1Char('\n'))));
  }
};

int main(int argc, char* argv[])
{
  return runWindowTest<TestStudioWords>(argc, argv);
}

#include "TestStudioWords.moc"
