// SPDX-License-Identifier: BSD-3-Clause
// Finds the point under the cursor.
#ifndef studio_Picking_h
#define studio_Picking_h

#include <optional>

#include "scene/SceneDocument.h"

class vtkOBBTree;

namespace studio
{
struct Pick
{
  Point position;  ///< m
  Point normal;    ///< unit, of the receivers there
  QString set;
};

class Picking
{
public:
  /// Searches these sets of the scene; sets of single points cannot be hit.
  Picking(const ScenePtr& scene, const QStringList& sets);

  /// The first thing from `from` on towards `to` that is seen: surfaces from their front, planes from both sides.
  std::optional<Pick> first(const Point& from, const Point& to) const;

private:
  struct Target
  {
    QString name;
    bool bothSides;
    vtkSmartPointer<vtkPolyData> data;
    vtkSmartPointer<vtkOBBTree> tree;
  };
  QVector<Target> Targets;
};
}  // namespace studio

#endif
