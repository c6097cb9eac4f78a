// SPDX-License-Identifier: BSD-3-Clause
#include "session/Preferences.h"

#include <QFileInfo>
#include <QSettings>

namespace studio
{
namespace
{
const QString recent = QStringLiteral("recentFiles"), lights = QStringLiteral("lightsOnOpening"),
              docks = QStringLiteral("windowLayout");
}

QStringList recentFiles()
{
  QStringList existing;
  for (const QString& path : QSettings().value(recent).toStringList())
    if (QFileInfo(path).isFile())
      existing << path;
  return existing;
}

void addRecentFile(const QString& path)
{
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(recent, QStringList(files.mid(0, 10)));
}

bool lightsOnOpening()
{
  return QSettings().value(lights, true).toBool();
}

void setLightsOnOpening(bool value)
{
  QSettings().setValue(lights, value);
}

QByteArray windowLayout()
{
  return QSettings().value(docks).toByteArray();
}

void setWindowLayout(const QByteArray& layout)
{
  QSettings().setValue(docks, layout);
}
}  // namespace studio
