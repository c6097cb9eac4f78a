// SPDX-License-Identifier: BSD-3-Clause
#include "session/Session.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>

#include "base/JsonFields.h"
#include "base/Problem.h"
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
}  // namespace

void saveSession(const Workbench& bench, const CameraPreset& camera, const QString& path)
{
  if (!bench.scene())
    throw Problem(QStringLiteral("%1: session: there is no scene; expected an open one").arg(path));
  const QDir results = resultsFolder(path), fresh(results.path() + QStringLiteral(".new"));
  QDir(fresh).removeRecursively();
  QJsonArray list;
  for (const ResultPtr& result : bench.results())
    if (result->complete)
    {
      QDir().mkpath(fresh.path());
      const QString name = QStringLiteral("%1.vtm").arg(list.size() + 1);
      writeResult(*result, fresh.filePath(name));
      list.append(QJsonObject{{QStringLiteral("settings"), result->settings.toJson()}, {QStringLiteral("file"), name}});
    }
  QJsonObject session{{QStringLiteral("kalos_edge_studio"), 1},
                      {QStringLiteral("scene"), QFileInfo(path).absoluteDir().relativeFilePath(bench.scene()->path())},
                      {QStringLiteral("settings"), bench.settings().toJson()},
                      {QStringLiteral("display"), bench.display().toJson()},
                      {QStringLiteral("compute"), QJsonArray::fromStringList(bench.chosenSets())},
                      {QStringLiteral("camera"), camera.toJson()},
                      {QStringLiteral("results"), list}};
  if (bench.study())
    session[QStringLiteral("study")] = bench.study()->toJson();
  if (const auto& request = bench.image().request())
  {
    session[QStringLiteral("image")] = request->toJson();
    if (const ResultPtr image = bench.image().result(); image && image->complete)
    {
      QDir().mkpath(fresh.path());
      writeImage(*image, fresh.filePath(imageFile));
    }
  }
  QSaveFile file(path);
  const QByteArray text = QJsonDocument(session).toJson();
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
    throw Problem(QStringLiteral("%1: file: %2; expected a place that can be written").arg(path, file.errorString()));
  QDir(results).removeRecursively();
  if (fresh.exists() && !QDir().rename(fresh.path(), results.path()))
    throw Problem(QStringLiteral("%1: file: can not be renamed; expected a writable folder").arg(fresh.path()));
  if (!file.commit())
    throw Problem(QStringLiteral("%1: file: %2; expected a place that can be written").arg(path, file.errorString()));
}

bool isSession(const QString& path)
{
  QFile file(path);
  return path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive) && file.open(QIODevice::ReadOnly) &&
         QJsonDocument::fromJson(file.readAll()).object().contains(QStringLiteral("kalos_edge_studio"));
}

std::optional<CameraPreset> openSession(Workbench& bench, const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw Problem(QStringLiteral("%1: file: %2; expected a session").arg(path, file.errorString()));
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &error);
  if (!document.isObject())
    throw Problem(
        QStringLiteral("%1: offset %2: %3; expected a session").arg(path).arg(error.offset).arg(error.errorString()));

  // Read everything before anything on the bench changes.
  JsonFields fields(document.object(), path + QStringLiteral(": session"));
  qint64 version = 1;
  QString scene;
  fields.integer(QStringLiteral("kalos_edge_studio"), version, 1);
  fields.text(QStringLiteral("scene"), scene);
  const auto settings =
      MethodSettings::fromJson(fields.object(QStringLiteral("settings")), fields.at(QStringLiteral("settings")));
  const auto display =
      Display::fromJson(fields.object(QStringLiteral("display")), fields.at(QStringLiteral("display")));
  QStringList compute;
  for (const QJsonValue& name : fields.array(QStringLiteral("compute")))
    compute << name.toString();
  const auto camera =
      CameraPreset::fromJson(fields.object(QStringLiteral("camera")), fields.at(QStringLiteral("camera")));
  QVector<ResultPtr> results;
  for (const QJsonValue& entry : fields.array(QStringLiteral("results")))
  {
    const QString where = fields.at(QStringLiteral("results/%1").arg(results.size()));
    JsonFields result(entry.toObject(), where);
    QString name;
    result.text(QStringLiteral("file"), name);
    const auto of =
        MethodSettings::fromJson(result.object(QStringLiteral("settings")), where + QStringLiteral("/settings"));
    result.finish();
    results << readResult(of, resultsFolder(path).filePath(QFileInfo(name).fileName()));
  }
  std::optional<Study> study;
  if (const QJsonObject object = fields.object(QStringLiteral("study")); !object.isEmpty())
    study = Study::fromJson(object, fields.at(QStringLiteral("study")));
  std::optional<ImageRequest> request;
  ResultPtr image;
  if (const QJsonObject object = fields.object(QStringLiteral("image")); !object.isEmpty())
  {
    request = ImageRequest::fromJson(object, fields.at(QStringLiteral("image")));
    if (const QString stored = resultsFolder(path).filePath(imageFile); QFileInfo(stored).isFile())
      image = readImage(request->settings, stored);
  }
  fields.finish();
  bench.open(QFileInfo(path).absoluteDir().absoluteFilePath(scene));
  bench.setSettings(settings);
  bench.setDisplay(display);
  bench.setChosenSets(compute);
  for (const ResultPtr& result : results)
    bench.addResult(result);
  bench.setStudy(study);
  if (image)
    bench.image().restore(*request, image);
  else if (request)
    bench.image().start(bench.scene(), *request);
  return camera;
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
