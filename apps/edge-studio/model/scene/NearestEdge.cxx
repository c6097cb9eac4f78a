// SPDX-License-Identifier: BSD-3-Clause
#include "scene/NearestEdge.h"

#include <algorithm>
#include <cmath>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkKalosSingularEdges.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace studio
{
std::optional<NearestEdge> nearestEdge(const SceneDocument& scene, const Point& point)
{
  using Edges = vtkKalosSingularEdges;
  std::optional<NearestEdge> nearest;
  vtkPolyData* edges = scene.edges();
  vtkCellData* data = edges->GetCellData();
  vtkDataArray *severity = data->GetArray(Edges::SeverityArrayName()),
               *angle = data->GetArray(Edges::DihedralAngleArrayName()),
               *kind = data->GetArray(Edges::EdgeClassArrayName());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; severity && i < edges->GetNumberOfCells(); ++i)
  {
    if (!(severity->GetComponent(i, 0) > 0))
      continue;
    edges->GetCellPoints(i, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      Point from, to;
      edges->GetPoint(ids->GetId(k), from.GetData());
      edges->GetPoint(ids->GetId(k + 1), to.GetData());
      const Point side = to - from;
      const double squared = side.SquaredNorm();
      if (!(squared > 0))
        continue;
      const double t = std::clamp((point - from).Dot(side) / squared, 0.0, 1.0);
      const Point foot = from + t * side;
      const double distance = (point - foot).Norm();
      if (nearest && distance >= nearest->distance)
        continue;
      nearest = NearestEdge{distance, angle->GetComponent(i, 0), foot, side.Normalized(),
                            kind->GetComponent(i, 0) == Edges::CONTACT};
    }
  }
  return nearest;
}

std::optional<ProbeLine> lineAcrossEdge(const ScenePtr& scene, const Pick& pick)
{
  const auto edge = nearestEdge(*scene, pick.position);
  if (!edge)
    return {};
  Point direction = pick.position - edge->foot;
  direction -= direction.Dot(pick.normal) * pick.normal;
  direction -= direction.Dot(edge->along) * edge->along;
  if (!(direction.Norm() > 1e-6 * scene->size()))
    return {};
  direction.Normalize();

  ProbeLine line{*edge, pick.normal, {}, {}};
  // From the edge at the height of the picked surface.
  const Point start = edge->foot + (pick.position - edge->foot).Dot(pick.normal) * pick.normal;
  const Picking surfaces(scene, {SceneDocument::paintedName()}), own(scene, {pick.set});
  const Point lift = 1e-3 * scene->size() * pick.normal;
  const auto wall = surfaces.first(start + lift + 1e-4 * direction, start + lift + scene->size() * direction);
  const double reach = wall ? (wall->position - start).Norm() : scene->size();
  for (int k = 0;; ++k)
  {
    const double distance = 1e-4 * std::pow(10.0, k / 10.0);
    const Point point = start + distance * direction;
    const bool held = distance < 0.01 * scene->size() || own.first(point + lift, point - lift);
    if (distance > 0.98 * reach || !held)
      break;
    line.distances << distance;
    line.points << point;
  }
  if (line.points.size() < 3)
    return {};
  return line;
}

vtkSmartPointer<vtkPolyData> pointReceivers(const QVector<Point>& points, const QVector<Point>& normals)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> directions;
  directions->SetNumberOfComponents(3);
  directions->SetName("Normals");
  vtkNew<vtkCellArray> vertices;
  for (int i = 0; i < points.size(); ++i)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(places->InsertNextPoint(points[i].GetData()));
    directions->InsertNextTuple(normals[i].GetData());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetVerts(vertices);
  data->GetPointData()->SetNormals(directions);
  return data;
}
}  // namespace studio
