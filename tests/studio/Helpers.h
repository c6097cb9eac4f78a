// SPDX-License-Identifier: BSD-3-Clause
// What the tests of Edge Studio share.
#ifndef Helpers_h
#define Helpers_h

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTest>
#include <cstdlib>

inline QString data(const QString& name)
{
  return QStringLiteral(KALOS_DATA "/") + name;
}

inline QString writeFile(const QDir& folder, const QString& name, const QByteArray& text)
{
  const QString path = folder.filePath(name);
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
    qFatal("%s cannot be written", qPrintable(path));
  return path;
}

inline double seconds(const QElapsedTimer& clock)
{
  return static_cast<double>(clock.elapsed()) / 1000;
}

/// Prints a figure with its goal, which an idle machine of two cores keeps, and the load of the machine, and keeps the
/// line in figures/TEST.txt beside the screenshots. Tests share theirs with whatever else runs, so that only twenty
/// times as much fails.
inline void figure(const QString& what, double value, const char* unit, double goal)
{
  static QFile file(
      QStringLiteral(KALOS_FIGURES "/%1.txt").arg(QFileInfo(QCoreApplication::applicationFilePath()).baseName()));
  if (!file.isOpen() && !file.open(QIODevice::WriteOnly | QIODevice::Truncate))
    qFatal("%s cannot be written", qPrintable(file.fileName()));
  double load = 0;
  getloadavg(&load, 1);
  const QString line = QStringLiteral("%1: %2 %3, goal %4 %3, load %5")
                           .arg(what)
                           .arg(value, 0, 'g', 4)
                           .arg(QString::fromUtf8(unit))
                           .arg(goal, 0, 'g', 3)
                           .arg(load, 0, 'f', 1);
  file.write(line.toUtf8() + '\n');
  file.flush();
  qInfo("figure: %s", qPrintable(line));
  QVERIFY2(value < 20 * goal, qPrintable(line));
}

/// A closed room without a lamp, white furnace of 250 lx, of six quads and a coarse plane.
inline QByteArray furnaceRoom()
{
  return R"({"kalos": 1, "materials": {"glow": {"reflectance": 0.6, "exitance": 100}},
    "surfaces": [
      {"name": "floor", "quad": {"origin": [0,0,0], "u": [4,0,0], "v": [0,3,0]}, "material": "glow"},
      {"name": "ceiling", "quad": {"origin": [0,0,2.5], "u": [0,3,0], "v": [4,0,0]}, "material": "glow"},
      {"name": "left", "quad": {"origin": [0,0,0], "u": [0,3,0], "v": [0,0,2.5]}, "material": "glow"},
      {"name": "right", "quad": {"origin": [4,0,0], "u": [0,0,2.5], "v": [0,3,0]}, "material": "glow"},
      {"name": "front", "quad": {"origin": [0,0,0], "u": [0,0,2.5], "v": [4,0,0]}, "material": "glow"},
      {"name": "back", "quad": {"origin": [0,3,0], "u": [4,0,0], "v": [0,0,2.5]}, "material": "glow"}],
    "receivers": [
      {"name": "desk", "plane": {"origin": [0,0,0.75], "u": [4,0,0], "v": [0,3,0], "resolution": [8,6]}}]})";
}

#endif
