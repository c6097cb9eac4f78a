// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>

#include "ErrorCollector.h"
#include "JsonFields.h"
#include "Problem.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace studio
{
namespace
{
QDir resultsFolder(const QString& path)
{
  const QFileInfo file(path);
  return QDir(file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral(".results")));
}

QJsonArray array(const std::array<double, 3>& values)
{
  return {values[0], values[1], values[2]};
}

QJsonObject toJson(const CameraPreset& camera)
{
  return {{QStringLiteral("position"), array(camera.position)},
          {QStringLiteral("target"), array(camera.target)},
          {QStringLiteral("up"), array(camera.up)},
          {QStringLiteral("fov_deg"), camera.fieldOfView}};
}

CameraPreset cameraFromJson(const QJsonObject& object, const QString& where)
{
  CameraPreset camera{QString(), {0, -1, 0}, {0, 0, 0}, {0, 0, 1}, 45};
  JsonFields fields(object, where);
  fields.numbers(QStringLiteral("position"), camera.position.data(), 3);
  fields.numbers(QStringLiteral("target"), camera.target.data(), 3);
  fields.numbers(QStringLiteral("up"), camera.up.data(), 3);
  fields.number(QStringLiteral("fov_deg"), camera.fieldOfView, 0.1, 179);
  fields.finish();
  return camera;
}

void writeResult(vtkDataObject* data, const QString& path)
{
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  const auto errors = ErrorCollector::watch(writer);
  writer->SetInputDataObject(data);
  writer->SetFileName(path.toUtf8().constData());
  if (!writer->Write() || !errors->message().isEmpty())
    throw Problem(QStringLiteral("%1: file: can not be written; expected a writable folder").arg(path));
}

ResultPtr readResult(const MethodSettings& settings, const QString& path)
{
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  const auto errors = ErrorCollector::watch(reader);
  if (!QFileInfo(path).isFile())
    throw Problem(QStringLiteral("%1: file: no such file; expected a result of the session").arg(path));
  reader->SetFileName(path.toUtf8().constData());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  if (!errors->message().isEmpty() || !blocks || blocks->GetNumberOfBlocks() == 0)
    throw Problem(QStringLiteral("%1: file: can not be read; expected a result of the session").arg(path));
  // The field data of the whole stand at each block too.
  if (vtkDataObject* first = blocks->GetBlock(0))
    blocks->GetFieldData()->ShallowCopy(first->GetFieldData());
  auto result = std::make_shared<Result>(makeResult(settings, blocks));
  result->complete = true;
  return result;
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
      writeResult(result->data, fresh.filePath(name));
      list.append(QJsonObject{{QStringLiteral("settings"), result->settings.toJson()}, {QStringLiteral("file"), name}});
    }
  const QJsonObject session{
      {QStringLiteral("kalos_edge_studio"), 1},
      {QStringLiteral("scene"), QFileInfo(path).absoluteDir().relativeFilePath(bench.scene()->path())},
      {QStringLiteral("settings"), bench.settings().toJson()},
      {QStringLiteral("display"), bench.display().toJson()},
      {QStringLiteral("compute"), QJsonArray::fromStringList(bench.chosenSets())},
      {QStringLiteral("camera"), toJson(camera)},
      {QStringLiteral("results"), list}};
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
  const CameraPreset camera =
      cameraFromJson(fields.object(QStringLiteral("camera")), fields.at(QStringLiteral("camera")));
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
  fields.finish();
  bench.open(QFileInfo(path).absoluteDir().absoluteFilePath(scene));
  bench.setSettings(settings);
  bench.setDisplay(display);
  bench.setChosenSets(compute);
  for (const ResultPtr& result : results)
    bench.addResult(result);
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
