// SPDX-License-Identifier: BSD-3-Clause
#include "scene/EdgeList.h"

#include <algorithm>
#include <cmath>

#include "base/DataSets.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkKalosSingularEdges.h"
#include "vtkNew.h"

namespace studio
{
namespace
{
/// Whether b goes on where a ends, in the same direction.
bool continues(const EdgePiece& a, const EdgePiece& b)
{
  const Point along = (a.to - a.from).Normalized(), next = (b.to - b.from).Normalized();
  return a.contact == b.contact && std::abs(a.severity - b.severity) < 1e-6 && along.Dot(next) > 1 - 1e-9 &&
         (b.from - a.to).Norm() < 1e-6 * a.length();
}

/// Joins pieces until none continues another.
QVector<EdgePiece> joined(QVector<EdgePiece> pieces)
{
  for (int i = 0; i < pieces.size(); ++i)
    for (int k = 0; k < pieces.size(); ++k)
      if (i != k && continues(pieces[i], pieces[k]))
      {
        pieces[i].to = pieces[k].to;
        pieces.remove(k);
        return joined(pieces);
      }
  return pieces;
}
}  // namespace

QVector<EdgePiece> edgePieces(const SceneDocument& scene)
{
  using Edges = vtkKalosSingularEdges;
  vtkPolyData* edges = scene.edges();
  vtkCellData* data = edges->GetCellData();
  vtkDataArray *severity = data->GetArray(Edges::SeverityArrayName()),
               *angle = data->GetArray(Edges::DihedralAngleArrayName()),
               *kind = data->GetArray(Edges::EdgeClassArrayName());
  QVector<EdgePiece> pieces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; severity && i < edges->GetNumberOfCells(); ++i)
  {
    edges->GetCellPoints(i, ids);
    for (vtkIdType k = 0; severity->GetComponent(i, 0) > 0 && k + 1 < ids->GetNumberOfIds(); ++k)
      pieces.append({Point(edges->GetPoint(ids->GetId(k))), Point(edges->GetPoint(ids->GetId(k + 1))),
                     angle->GetComponent(i, 0), severity->GetComponent(i, 0),
                     kind->GetComponent(i, 0) == Edges::CONTACT});
  }
  if (pieces.size() < 200)  // large scenes have too many to join
    pieces = joined(pieces);
  std::stable_sort(pieces.begin(), pieces.end(), [](const EdgePiece& a, const EdgePiece& b) {
    return a.severity != b.severity ? a.severity > b.severity : a.length() > b.length() + 1e-9;
  });
  return pieces;
}

std::optional<std::array<Flank, 2>> flanksOf(const SceneDocument& scene, const EdgePiece& edge)
{
  // Cells near the middle whose plane contains the edge, the nearest first.
  struct Candidate
  {
    double distance;
    Flank flank;
  };
  std::vector<Candidate> candidates;
  vtkPolyData* cells = scene.painted().receivers;
  vtkDataArray* normals = cells->GetCellData()->GetNormals();
  const Point along = (edge.to - edge.from).Normalized();
  for (vtkIdType i = 0; normals && i < cells->GetNumberOfCells(); ++i)
  {
    const Point normal(normals->GetTuple3(i)), offset = cellCentre(cells, i) - edge.middle();
    const Point across = offset - offset.Dot(along) * along;
    if (std::abs(offset.Dot(along)) < 0.5 * edge.length() && std::abs(normal.Dot(along)) < 1e-3 &&
        std::abs(across.Dot(normal)) < 1e-4 * scene.size())
      candidates.push_back({across.Norm(), {normal, across.Normalized()}});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  for (std::size_t second = 1; second < candidates.size(); ++second)
    for (std::size_t first = 0; first < second; ++first)
    {
      const Flank &a = candidates[first].flank, &b = candidates[second].flank;
      if (a.away.Dot(b.normal) > 1e-3 && b.away.Dot(a.normal) > 1e-3)
        return std::array<Flank, 2>{a, b};
    }
  return {};
}
}  // namespace studio
