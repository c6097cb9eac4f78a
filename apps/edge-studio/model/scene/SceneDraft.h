// SPDX-License-Identifier: BSD-3-Clause
// A scene file in memory, to be edited and saved. All functions leave the draft that they are given as it is.
#ifndef studio_SceneDraft_h
#define studio_SceneDraft_h

#include <QJsonObject>
#include <QStringList>

#include "base/Point.h"

namespace studio
{
/// Of a scene file; of a model or a bare mesh, a scene file around it. Paths are absolute. Throws Problem.
QJsonObject draftOf(const QString& path);

/// Writes a scene file; paths of files below its folder become relative. Throws Problem.
void saveDraft(const QJsonObject& draft, const QString& path);

/// The way to a value: keys of objects, and indices of arrays as numbers, such as luminaires, 0, position.
using DraftPath = QStringList;

QJsonValue valueAt(const QJsonValue& root, const DraftPath& path);
QJsonObject withValue(const QJsonObject& draft, const DraftPath& path, const QJsonValue& value);

/// Without the entry of a list or of the materials.
QJsonObject withoutEntry(const QJsonObject& draft, const DraftPath& entry);

/// With a copy after the entry; its name gets a number.
QJsonObject withCopy(const QJsonObject& draft, const DraftPath& entry);

/// With a point luminaire of 1000 lm that shines downwards; `photometry` is an IES or EULUMDAT file, or empty.
QJsonObject withLuminaire(const QJsonObject& draft, const Point& position, const QString& photometry = {});

/// With a calculation plane of 16 x 16 points, 0.75 m above the floor of these bounds.
QJsonObject withPlane(const QJsonObject& draft, const double bounds[6]);

/// What a user types: JSON, or a text where it is none.
QJsonValue parsedValue(const QString& text);
QString valueText(const QJsonValue& value);
}  // namespace studio

#endif
