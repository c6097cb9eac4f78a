// SPDX-License-Identifier: BSD-3-Clause
#include "session/RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace studio
{
namespace
{
const QString key = QStringLiteral("recentFiles");
}

QStringList recentFiles()
{
  QStringList existing;
  for (const QString& path : QSettings().value(key).toStringList())
    if (QFileInfo(path).isFile())
      existing << path;
  return existing;
}

void addRecentFile(const QString& path)
{
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(key, QStringList(files.mid(0, 10)));
}
}  // namespace studio
