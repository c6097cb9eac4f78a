// SPDX-License-Identifier: BSD-3-Clause
#include "window/Application.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPalette>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <clocale>

#include "vtkObject.h"

namespace studio
{
void prepareApplication()
{
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setOrganizationName(QStringLiteral("Kalos"));
  QCoreApplication::setApplicationName(QStringLiteral("Edge Studio"));
  QCoreApplication::setApplicationVersion(QStringLiteral(KALOS_VERSION));
  QLocale::setDefault(QLocale::c());    // numbers have points, in files and beside them
  vtkObject::GlobalWarningDisplayOn();  // error events are not sent without
}

void styleApplication()
{
  std::setlocale(LC_NUMERIC, "C");  // QApplication takes over the user's, and readers of numbers would follow it
  // Neutral greys do not change how the colours of the picture look.
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QPalette palette(QColor(0xf1, 0xf1, 0xf2));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf7, 0xf7, 0xf8));
  palette.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xb5));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  QApplication::setPalette(palette);
}

QString demoScene()
{
  const QDir program(QCoreApplication::applicationDirPath());
  const QString installed = program.filePath(QStringLiteral(KALOS_DATA_INSTALLED "/cornell/cornell.json"));
  return QFileInfo(installed).isFile() ? installed : QStringLiteral(KALOS_DATA_IN_SOURCES "/cornell/cornell.json");
}
}  // namespace studio
