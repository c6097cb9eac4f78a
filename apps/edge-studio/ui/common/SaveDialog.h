// SPDX-License-Identifier: BSD-3-Clause
// Asks where to save, so that names get their suffix and nothing is replaced unasked.
#ifndef studio_SaveDialog_h
#define studio_SaveDialog_h

#include <QString>
#include <QVector>

class QWidget;

namespace studio
{
struct FileKind
{
  QString name;    ///< "OpenEXR"
  QString suffix;  ///< "exr"
};

/// Adds the suffix of the chosen kind, unless the path has that of one of the kinds already.
QString withSuffix(QString path, const QVector<FileKind>& kinds, const FileKind& chosen);

/// Asks before files are replaced; true where none of them exists.
bool mayReplace(QWidget* parent, const QStringList& paths);

/// Empty where the user gave up.
QString askSavePath(QWidget* parent, const QString& title, const QVector<FileKind>& kinds);
}  // namespace studio

#endif
