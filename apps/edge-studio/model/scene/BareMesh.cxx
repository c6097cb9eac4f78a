// SPDX-License-Identifier: BSD-3-Clause
#include "scene/BareMesh.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace studio
{
namespace
{
const QString unseenName = QStringLiteral("unseen");
}

bool isBareMesh(const QString& path)
{
  static const QStringList meshes{QStringLiteral("ply"), QStringLiteral("stl"), QStringLiteral("vtp")};
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix != QStringLiteral("obj"))
    return meshes.contains(suffix);
  QFile file(path);
  if (file.open(QIODevice::ReadOnly))
    while (!file.atEnd())
      if (file.readLine().simplified().startsWith("mtllib "))
        return false;  // it brings its materials
  return true;
}

QJsonObject unseenCamera()
{
  return {{QStringLiteral("name"), unseenName},
          {QStringLiteral("position"), QJsonArray{0, -1, 0}},
          {QStringLiteral("target"), QJsonArray{0, 0, 0}},
          {QStringLiteral("up"), QJsonArray{0, 0, 1}},
          {QStringLiteral("fov_deg"), 45},
          {QStringLiteral("resolution"), QJsonArray{8, 8}}};
}

bool isUnseen(const QString& cameraName)
{
  return cameraName == unseenName;
}

QByteArray furnaceAround(const QString& meshFile)
{
  const QJsonObject glow{{QStringLiteral("reflectance"), 0.5}, {QStringLiteral("exitance"), 100}};
  QJsonObject materials{{QStringLiteral("glow"), glow}};
  QFile file(meshFile);
  if (meshFile.endsWith(QStringLiteral(".obj"), Qt::CaseInsensitive) && file.open(QIODevice::ReadOnly))
    while (!file.atEnd())
    {
      const QByteArray line = file.readLine().simplified();
      if (line.startsWith("usemtl "))
        materials[QString::fromUtf8(line.mid(7))] = glow;
    }
  const QJsonObject surface{{QStringLiteral("name"), QStringLiteral("mesh")},
                            {QStringLiteral("file"), QFileInfo(meshFile).absoluteFilePath()},
                            {QStringLiteral("material"), QStringLiteral("glow")}};
  return QJsonDocument(QJsonObject{{QStringLiteral("kalos"), 1},
                                   {QStringLiteral("materials"), materials},
                                   {QStringLiteral("surfaces"), QJsonArray{surface}},
                                   {QStringLiteral("cameras"), QJsonArray{unseenCamera()}}})
      .toJson();
}
}  // namespace studio
