// SPDX-License-Identifier: BSD-3-Clause
#include "common/SaveDialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace studio
{
namespace
{
QString tr(const char* text)
{
  return QCoreApplication::translate("SaveDialog", text);
}
}  // namespace

QString withSuffix(QString path, const QVector<FileKind>& kinds, const FileKind& chosen)
{
  for (const FileKind& kind : kinds)
    if (path.endsWith(QLatin1Char('.') + kind.suffix, Qt::CaseInsensitive))
      return path;
  // A part of the suffix is completed: room.json becomes room.kalos-session.json.
  const QString own = QLatin1Char('.') + QFileInfo(path).suffix();
  if (own.size() > 1 && chosen.suffix.endsWith(own, Qt::CaseInsensitive))
    path.chop(own.size());
  return path + QLatin1Char('.') + chosen.suffix;
}

bool mayReplace(QWidget* parent, const QStringList& paths)
{
  QStringList existing;
  for (const QString& path : paths)
    if (QFileInfo(path).exists())
      existing << path;
  if (existing.isEmpty())
    return true;
  QMessageBox box(QMessageBox::Question, tr("Edge Studio"),
                  existing.size() == 1 ? tr("A file of this name exists. Replace it?")
                                       : tr("%1 files of these names exist. Replace them?").arg(existing.size()),
                  QMessageBox::Yes | QMessageBox::No, parent);
  box.setObjectName(QStringLiteral("replacing"));
  box.setInformativeText(existing.join(QLatin1Char('\n')));
  return box.exec() == QMessageBox::Yes;
}

QString askSavePath(QWidget* parent, const QString& title, const QVector<FileKind>& kinds)
{
  QFileDialog dialog(parent, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setOption(QFileDialog::DontConfirmOverwrite);  // the name gets its suffix first
  QStringList filters;
  for (const FileKind& kind : kinds)
    filters << QStringLiteral("%1 (*.%2)").arg(kind.name, kind.suffix);
  dialog.setNameFilters(filters);
  while (dialog.exec() == QDialog::Accepted)
  {
    const auto chosen = static_cast<int>(filters.indexOf(dialog.selectedNameFilter()));
    const QString path = withSuffix(dialog.selectedFiles().value(0), kinds, kinds.value(chosen, kinds.front()));
    if (mayReplace(parent, {path}))
      return path;
  }
  return {};
}
}  // namespace studio
