// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneDraft.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>
#include <functional>

#include "base/Files.h"
#include "scene/BareMesh.h"

namespace studio
{
namespace
{
const QString surfaces = QStringLiteral("surfaces"), luminaires = QStringLiteral("luminaires"),
              receivers = QStringLiteral("receivers"), nameKey = QStringLiteral("name"),
              fileKey = QStringLiteral("file");

/// Changes every path in the draft.
QJsonObject withPaths(QJsonObject draft, const std::function<QString(const QString&)>& change)
{
  for (const QString& section : {surfaces, luminaires, receivers})
  {
    QJsonArray entries = draft.value(section).toArray();
    for (int i = 0; i < entries.size(); ++i)
    {
      QJsonObject entry = entries[i].toObject();
      for (const QString& key : {fileKey, QStringLiteral("points")})
        if (entry.value(key).isString())
          entry[key] = change(entry.value(key).toString());
      if (entries[i].isObject())
        entries[i] = entry;
    }
    if (!entries.isEmpty())
      draft[section] = entries;
  }
  return draft;
}

QSet<QString> namesIn(const QJsonArray& entries)
{
  QSet<QString> names;
  for (const QJsonValue& entry : entries)
    names << entry.toObject()[nameKey].toString();
  return names;
}

QString freeName(const QString& wish, const QSet<QString>& taken)
{
  QString name = wish;
  for (int i = 2; taken.contains(name); ++i)
    name = QStringLiteral("%1 %2").arg(wish).arg(i);
  return name;
}

QJsonObject withEntry(QJsonObject draft, const QString& section, QJsonObject entry)
{
  QJsonArray entries = draft.value(section).toArray();
  entry[nameKey] = freeName(entry.value(nameKey).toString(), namesIn(entries));
  entries.append(entry);
  draft[section] = entries;
  return draft;
}
}  // namespace

QJsonObject draftOf(const QString& path)
{
  const QFileInfo info(path);
  if (isBareMesh(path))
    return QJsonDocument::fromJson(furnaceAround(path)).object();
  if (info.suffix().toLower() != QLatin1String("json"))
    return {{QStringLiteral("kalos"), 1},
            {surfaces, QJsonArray{QJsonObject{{nameKey, info.completeBaseName()}, {fileKey, info.absoluteFilePath()}}}},
            {QStringLiteral("cameras"), QJsonArray{unseenCamera()}}};
  QFile file(path);
  QJsonParseError error;
  error.error = QJsonParseError::NoError;
  const bool opened = file.open(QIODevice::ReadOnly);
  const QJsonObject draft = opened ? QJsonDocument::fromJson(file.readAll(), &error).object() : QJsonObject();
  if (!opened || error.error != QJsonParseError::NoError)
    throw Problem(QStringLiteral("%1: file: %2; expected a scene file")
                      .arg(path, opened ? error.errorString() : file.errorString()));
  const QDir folder = info.absoluteDir();
  return withPaths(draft, [&](const QString& name) { return QDir::cleanPath(folder.absoluteFilePath(name)); });
}

void saveDraft(const QJsonObject& draft, const QString& path)
{
  const QDir folder = QFileInfo(path).absoluteDir();
  const QJsonObject stored = withPaths(draft, [&](const QString& name) {
    const QString relative = folder.relativeFilePath(name);
    return relative.startsWith(QLatin1String("..")) ? name : relative;
  });
  writeFile(path, QJsonDocument(stored).toJson());
}

QJsonValue valueAt(const QJsonValue& root, const DraftPath& path)
{
  QJsonValue value = root;
  for (const QString& step : path)
    value = value.isArray() ? value.toArray().at(step.toInt()) : value.toObject()[step];
  return value;
}

namespace
{
QJsonValue changed(const QJsonValue& root, const DraftPath& path, const QJsonValue& value)
{
  if (path.isEmpty())
    return value;
  const DraftPath rest = path.mid(1);
  if (root.isArray())
  {
    QJsonArray array = root.toArray();
    const int index = path.front().toInt();
    array[index] = changed(array.at(index), rest, value);
    return array;
  }
  QJsonObject object = root.toObject();
  object[path.front()] = changed(object[path.front()], rest, value);
  return object;
}
}  // namespace

QJsonObject withValue(const QJsonObject& draft, const DraftPath& path, const QJsonValue& value)
{
  return changed(draft, path, value).toObject();
}

QJsonObject withoutEntry(const QJsonObject& draft, const DraftPath& entry)
{
  const DraftPath section = entry.mid(0, 1);
  QJsonValue list = valueAt(draft, section);
  if (list.isArray())
  {
    QJsonArray array = list.toArray();
    array.removeAt(entry[1].toInt());
    return withValue(draft, section, array);
  }
  QJsonObject object = list.toObject();
  object.remove(entry[1]);
  return withValue(draft, section, object);
}

QJsonObject withCopy(const QJsonObject& draft, const DraftPath& entry)
{
  const QJsonValue list = valueAt(draft, entry.mid(0, 1)), original = valueAt(draft, entry);
  if (list.isArray())
    return withEntry(draft, entry[0], original.toObject());
  const QStringList keys = list.toObject().keys();
  return withValue(draft, {entry[0], freeName(entry[1], QSet<QString>(keys.begin(), keys.end()))}, original);
}

QJsonObject withLuminaire(const QJsonObject& draft, const Point& position, const QString& photometry)
{
  QJsonObject lamp{{nameKey, QStringLiteral("lamp")},
                   {QStringLiteral("position"), QJsonArray{position[0], position[1], position[2]}},
                   {QStringLiteral("aim"), QJsonArray{0, 0, -1}}};
  if (photometry.isEmpty())
  {
    lamp[QStringLiteral("flux")] = 1000;
    lamp[QStringLiteral("distribution")] = QStringLiteral("lambertian");
  }
  else
    lamp[fileKey] = QFileInfo(photometry).absoluteFilePath();
  return withEntry(draft, luminaires, lamp);
}

QJsonObject withPlane(const QJsonObject& draft, const double bounds[6])
{
  const QJsonObject plane{{QStringLiteral("origin"), QJsonArray{bounds[0], bounds[2], bounds[4] + 0.75}},
                          {QStringLiteral("u"), QJsonArray{bounds[1] - bounds[0], 0, 0}},
                          {QStringLiteral("v"), QJsonArray{0, bounds[3] - bounds[2], 0}},
                          {QStringLiteral("resolution"), QJsonArray{16, 16}}};
  return withEntry(draft, receivers, {{nameKey, QStringLiteral("plane")}, {QStringLiteral("plane"), plane}});
}

QJsonValue parsedValue(const QString& text)
{
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson('[' + text.toUtf8() + ']', &error);
  const QJsonArray values = document.array();
  return error.error == QJsonParseError::NoError && values.size() == 1 ? values.first() : QJsonValue(text);
}

QString valueText(const QJsonValue& value)
{
  if (value.isString())
    return value.toString();
  const QString text = QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
  return text.mid(1, text.size() - 2);
}
}  // namespace studio
