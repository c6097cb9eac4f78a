// SPDX-License-Identifier: BSD-3-Clause
#include "base/Files.h"

#include <QSaveFile>

namespace studio
{
namespace
{
[[noreturn]] void refuse(const QSaveFile& file)
{
  throw Problem(
      QStringLiteral("%1: file: %2; expected a place that can be written").arg(file.fileName(), file.errorString()));
}
}  // namespace

void fillFile(QSaveFile& file, const QByteArray& bytes)
{
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    refuse(file);
}

void commitFile(QSaveFile& file)
{
  if (!file.commit())
    refuse(file);
}

void writeFile(const QString& path, const QByteArray& bytes)
{
  QSaveFile file(path);
  fillFile(file, bytes);
  commitFile(file);
}
}  // namespace studio
