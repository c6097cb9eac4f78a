// SPDX-License-Identifier: BSD-3-Clause
// Makes a scene of a mesh file that has no light of its own.
#ifndef studio_BareMesh_h
#define studio_BareMesh_h

#include <QJsonObject>
#include <QString>

namespace studio
{
/// By its name; an OBJ with a library of materials is not.
bool isBareMesh(const QString& path);

/// A camera that is not shown: a scene file needs a receiver or a camera.
QJsonObject unseenCamera();
bool isUnseen(const QString& cameraName);

/// The text of a scene file with this mesh as a white furnace; every `usemtl` name of an OBJ gets the same material.
QByteArray furnaceAround(const QString& meshFile);
}  // namespace studio

#endif
