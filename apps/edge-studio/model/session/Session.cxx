// SPDX-License-Identifier: BSD-3-Clause
#include "session/Session.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>

#include "base/Files.h"
#include "base/JsonFields.h"
#include "results/ResultFiles.h"

namespace studio
{
namespace
{
const QString imageFile = QStringLiteral("image.vti");

QDir resultsFolder(const QString& path)
{
  const QFileInfo file(path);
  return QDir(file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral(".results")));
}

/// Writes what runs have found into a folder, and returns the list of them.
QJsonArray writeResults(const Workbench& bench, const QDir& folder)
{
  QJsonArray list;
  for (const ResultPtr& result : bench.results())
    if (result && !result->preview)
    {
      QDir().mkpath(folder.path());
      const QString name = QStringLiteral("%1.vtm").arg(list.size() + 1);
      writeResult(*result, folder.filePath(name));
      list.append(QJsonObject{{QStringLiteral("settings"), result->settings.toJson()},
                              {QStringLiteral("complete"), result->complete},
                              {QStringLiteral("name"), result->name},
                              {QStringLiteral("file"), name}});
    }
  if (const ResultPtr image = bench.image().result(); image && image->complete)
  {
    QDir().mkpath(folder.path());
    writeImage(*image, folder.filePath(imageFile));
  }
  return list;
}
}  // namespace

void saveSession(const Workbench& bench, const CameraPreset& camera, const QString& path)
{
  if (!bench.scene())
    throw Problem(QStringLiteral("%1: session: there is no scene; expected an open one").arg(path));
  if (QFileInfo(path).exists() && !isSession(path))
    throw Problem(QStringLiteral("%1: file: is not a session; expected a new name or that of a session").arg(path));
  const QDir results = resultsFolder(path), fresh(results.path() + QStringLiteral(".new"));
  QDir(fresh).removeRecursively();
  QJsonObject session{{QStringLiteral("kalos_edge_studio"), 1},
                      {QStringLiteral("scene"), QFileInfo(path).absoluteDir().relativeFilePath(bench.scene()->path())},
                      {QStringLiteral("turned"), bench.scene()->isTurned()},
                      {QStringLiteral("settings"), bench.settings().toJson()},
                      {QStringLiteral("display"), bench.display().toJson()},
                      {QStringLiteral("compute"), QJsonArray::fromStringList(bench.chosenSets())},
                      {QStringLiteral("camera"), camera.toJson()},
                      {QStringLiteral("results"), writeResults(bench, fresh)}};
  if (bench.isEdited())
    session[QStringLiteral("draft")] = bench.draft();
  QJsonObject required;
  for (auto it = bench.requirements().begin(); it != bench.requirements().end(); ++it)
    required[it.key()] = it.value().toJson();
  if (!required.isEmpty())
    session[QStringLiteral("requirements")] = required;
  if (bench.study())
    session[QStringLiteral("study")] = bench.study()->toJson();
  if (const auto& request = bench.image().request())
    session[QStringLiteral("image")] = request->toJson();
  QSaveFile file(path);
  fillFile(file, QJsonDocument(session).toJson());
  QDir(results).removeRecursively();
  if (fresh.exists() && !QDir().rename(fresh.path(), results.path()))
    throw Problem(QStringLiteral("%1: file: cannot be renamed; expected a writable folder").arg(fresh.path()));
  commitFile(file);
}

bool isSession(const QString& path)
{
  QFile file(path);
  return path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive) && file.open(QIODevice::ReadOnly) &&
         QJsonDocument::fromJson(file.readAll()).object().contains(QStringLiteral("kalos_edge_studio"));
}

namespace
{
/// What a session file says, with its results.
struct Stored
{
  QString scene;
  bool turned = false;
  MethodSettings settings;
  Display display;
  QStringList compute;
  CameraPreset camera;
  QVector<ResultPtr> results;
  QJsonObject draft;  // of an edited scene; else empty
  QHash<QString, Requirement> requirements;
  std::optional<Study> study;
  std::optional<ImageRequest> request;
  ResultPtr image;
};

QJsonObject objectIn(const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw Problem(QStringLiteral("%1: file: %2; expected a session").arg(path, file.errorString()));
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &error);
  if (!document.isObject())
    throw Problem(
        QStringLiteral("%1: offset %2: %3; expected a session").arg(path).arg(error.offset).arg(error.errorString()));
  return document.object();
}

QVector<ResultPtr> readResults(const QJsonArray& list, const QString& where, const QDir& folder)
{
  QVector<ResultPtr> results;
  for (const QJsonValue& entry : list)
  {
    JsonFields fields(entry.toObject(), where + QStringLiteral("/%1").arg(results.size()));
    QString file, name;
    MethodSettings settings;
    bool complete = true;
    fields.text(QStringLiteral("file"), file);
    fields.text(QStringLiteral("name"), name);
    fields.read(QStringLiteral("settings"), settings);
    fields.flag(QStringLiteral("complete"), complete);
    fields.finish();
    auto result =
        std::make_shared<Result>(*readResult(settings, complete, folder.filePath(QFileInfo(file).fileName())));
    result->name = name;
    results << result;
  }
  return results;
}

Stored read(const QString& path)
{
  Stored stored;
  JsonFields fields(objectIn(path), path + QStringLiteral(": session"));
  const QString results = QStringLiteral("results"), study = QStringLiteral("study"), image = QStringLiteral("image");
  qint64 version = 1;
  fields.integer(QStringLiteral("kalos_edge_studio"), version, 1);
  fields.text(QStringLiteral("scene"), stored.scene);
  fields.flag(QStringLiteral("turned"), stored.turned);
  fields.read(QStringLiteral("settings"), stored.settings);
  fields.read(QStringLiteral("display"), stored.display);
  fields.texts(QStringLiteral("compute"), stored.compute);
  fields.read(QStringLiteral("camera"), stored.camera);
  stored.results = readResults(fields.array(results), fields.at(results), resultsFolder(path));
  stored.draft = fields.object(QStringLiteral("draft"));
  const QString requirements = QStringLiteral("requirements");
  const QJsonObject required = fields.object(requirements);
  for (const QString& set : required.keys())
    stored.requirements[set] =
        Requirement::fromJson(required[set].toObject(), fields.at(requirements) + QLatin1Char('/') + set);
  if (!fields.object(study).isEmpty())
    fields.read(study, stored.study.emplace());
  if (!fields.object(image).isEmpty())
  {
    fields.read(image, stored.request.emplace());
    if (const QString kept = resultsFolder(path).filePath(imageFile); QFileInfo(kept).isFile())
      stored.image = readImage(stored.request->settings, kept);
  }
  fields.finish();
  return stored;
}
}  // namespace

CameraPreset openSession(Workbench& bench, const QString& path)
{
  const Stored stored = read(path);  // before anything on the bench changes
  bench.open(QFileInfo(path).absoluteDir().absoluteFilePath(stored.scene), stored.turned);
  if (!stored.draft.isEmpty())
    bench.edit(stored.draft);
  bench.setSettings(stored.settings);
  bench.setDisplay(stored.display);
  bench.setChosenSets(stored.compute);
  for (const ResultPtr& result : stored.results)
    bench.addResult(result);
  for (auto it = stored.requirements.begin(); it != stored.requirements.end(); ++it)
    bench.require(it.key(), it.value());
  bench.setStudy(stored.study);
  if (stored.image)
    bench.image().restore(*stored.request, stored.image);
  else if (stored.request)
    bench.image().start(bench.scene(), *stored.request);
  return stored.camera;
}

namespace
{
QString ownFile(const QString& name)
{
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  QDir().mkpath(folder.path());
  return folder.filePath(name);
}
}  // namespace

QString autosavePath()
{
  return ownFile(QStringLiteral("autosave.json"));
}

QString lastSessionPath()
{
  return ownFile(QStringLiteral("last.json"));
}

void removeSession(const QString& path)
{
  QFile::remove(path);
  resultsFolder(path).removeRecursively();
}
}  // namespace studio
