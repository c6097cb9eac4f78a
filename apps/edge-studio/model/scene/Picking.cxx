// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Picking.h"

#include "base/DataSets.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBBTree.h"
#include "vtkPoints.h"

namespace studio
{
Picking::Picking(const ScenePtr& scene, const QStringList& sets)
{
  for (const NamedSet& set : dataSets(scene->receivers(sets)))
  {
    vtkPolyData* data =
        set.name == SceneDocument::paintedName() ? scene->painted().shape.Get() : vtkPolyData::SafeDownCast(set.data);
    if (!data || data->GetNumberOfCells() == 0 || !data->GetCellData()->GetNormals())
      continue;
    auto tree = vtkSmartPointer<vtkOBBTree>::New();
    tree->SetDataSet(data);
    this->Targets.push_back({set.name, data->GetCellType(0) != VTK_TRIANGLE, data, tree});
  }
}

std::optional<Pick> Picking::first(const Point& from, const Point& to) const
{
  std::optional<Pick> nearest;
  const Point direction = to - from;
  double least = direction.SquaredNorm();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdList> cells;
  for (const Target& target : this->Targets)
  {
    target.tree->BuildLocator();  // where it has not been built
    target.tree->IntersectWithLine(from.GetData(), to.GetData(), points, cells);
    for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
    {
      Pick pick{{}, {}, target.name};
      points->GetPoint(i, pick.position.GetData());
      target.data->GetCellData()->GetNormals()->GetTuple(cells->GetId(i), pick.normal.GetData());
      const double distance = (pick.position - from).SquaredNorm();
      const bool seen = target.bothSides || direction.Dot(pick.normal) < 0;
      if (!seen || distance >= least)
        continue;
      least = distance;
      nearest = pick;
    }
  }
  return nearest;
}
}  // namespace studio
