// SPDX-License-Identifier: BSD-3-Clause
#include "scene/NearestEdge.h"

#include <algorithm>
#include <cmath>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkKalosSingularEdges.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace studio
{
namespace
{
Point combine(const Point& a, double t, const Point& b)
{
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

double dot(const Point& a, const Point& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

double length(const Point& a)
{
  return vtkMath::Norm(a.data());
}
}  // namespace

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
      edges->GetPoint(ids->GetId(k), from.data());
      edges->GetPoint(ids->GetId(k + 1), to.data());
      const Point side = combine(to, -1, from);
      const double squared = dot(side, side);
      if (!(squared > 0))
        continue;
      const double t = std::clamp(dot(combine(point, -1, from), side) / squared, 0.0, 1.0);
      const Point foot = combine(from, t, side);
      const double distance = length(combine(point, -1, foot));
      if (nearest && distance >= nearest->distance)
        continue;
      const double scale = 1 / std::sqrt(squared);
      nearest = NearestEdge{distance,
                            angle->GetComponent(i, 0),
                            foot,
                            {scale * side[0], scale * side[1], scale * side[2]},
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
  Point direction = combine(pick.position, -1, edge->foot);
  direction = combine(direction, -dot(direction, pick.normal), pick.normal);
  direction = combine(direction, -dot(direction, edge->along), edge->along);
  if (!(length(direction) > 1e-6 * scene->size()))
    return {};
  vtkMath::Normalize(direction.data());

  ProbeLine line{*edge, pick.normal, {}, {}};
  // From the edge at the height of the picked surface.
  const Point start = combine(edge->foot, dot(combine(pick.position, -1, edge->foot), pick.normal), pick.normal);
  const Picking surfaces(scene, {SceneDocument::paintedName()});
  const double lift = 1e-3 * scene->size();
  const bool onSurface = pick.set == SceneDocument::paintedName();
  const auto wall = surfaces.first(combine(combine(start, lift, pick.normal), 1e-4, direction),
                                   combine(combine(start, lift, pick.normal), scene->size(), direction));
  const double reach = wall ? length(combine(wall->position, -1, start)) : scene->size();
  for (int k = 0;; ++k)
  {
    const double distance = 1e-4 * std::pow(10.0, k / 10.0);
    const Point point = combine(start, distance, direction);
    const bool held = !onSurface || distance < 0.01 * scene->size() ||
                      surfaces.first(combine(point, lift, pick.normal), combine(point, -lift, pick.normal));
    if (distance > 0.98 * reach || !held)
      break;
    line.distances << distance;
    line.points << point;
  }
  if (line.points.size() < 3)
    return {};
  return line;
}

vtkSmartPointer<vtkPolyData> pointReceivers(const QVector<Point>& points, const Point& normal)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  vtkNew<vtkCellArray> vertices;
  for (const Point& point : points)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(places->InsertNextPoint(point.data()));
    normals->InsertNextTuple(normal.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetVerts(vertices);
  data->GetPointData()->SetNormals(normals);
  return data;
}
}  // namespace studio
