// SPDX-License-Identifier: BSD-3-Clause
// What tests of the real window share: finding its widgets, answering its dialogs, keeping screenshots and figures.
#ifndef WindowTest_h
#define WindowTest_h

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

#include "Helpers.h"
#include "session/Preferences.h"
#include "window/Application.h"
#include "window/MainWindow.h"

class WindowTest : public QObject
{
protected:
  QTemporaryDir Folder;
  std::unique_ptr<studio::MainWindow> Window;

  void open()
  {
    this->Window = std::make_unique<studio::MainWindow>();
    this->Window->show();
    QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
  }

  template <class Widget>
  Widget* find(const char* name)
  {
    auto* widget = this->Window->findChild<Widget*>(name);
    if (!widget)
      qFatal("no widget %s", name);
    return widget;
  }
  QString furnace() { return writeFile(this->Folder.path(), "furnace.json", furnaceRoom()); }
  void click(const char* name) { QTest::mouseClick(this->find<QPushButton>(name), Qt::LeftButton); }
  void settle()
  {
    QTest::qWait(150);
    QApplication::processEvents();
  }
  void keep(const QString& name)
  {
    this->settle();
    const QPixmap picture = this->Window->grab();
    const QString scaling = picture.devicePixelRatio() > 1.5 ? QStringLiteral("-200-per-cent") : QString();
    QVERIFY(picture.save(QStringLiteral(KALOS_SCREENSHOTS "/%1%2.png").arg(name, scaling)));
  }
  /// Answers the next dialog and returns what it said.
  std::shared_ptr<QString> answer(QMessageBox::StandardButton button)
  {
    auto said = std::make_shared<QString>();
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, [=] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box)
        return;
      *said = box->text() + QLatin1Char('\n') + box->informativeText();
      timer->deleteLater();
      box->button(button)->click();  // a click of the mouse is lost where the dialog is not exposed yet
    });
    timer->start(20);
    return said;
  }
};

/// As the program does it; with settings of its own, by which an opened scene stays dark until a test runs it.
inline void prepareTest()
{
  static const QTemporaryDir settings;
  studio::styleApplication();
  QStandardPaths::setTestModeEnabled(true);
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  studio::setLightsOnOpening(false);
}

/// The main function of a test of the window.
template <class Test>
int runWindowTest(int argc, char* argv[])
{
  studio::prepareApplication();
  QApplication application(argc, argv);
  prepareTest();
  Test test;
  return QTest::qExec(&test, argc, argv);
}

#endif
