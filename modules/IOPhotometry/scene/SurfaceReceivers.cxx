// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceReceivers.h"

#include <algorithm>
#include <stdexcept>

#include "SceneReceivers.h"
#include "mesh/Triangulation.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

namespace kalos::scene
{
namespace
{
using Triangle = std::array<Vector3, 3>;

/** Corner numbers of triangles: of a convex polygon by VTK, which takes the shorter diagonals. */
std::vector<std::array<std::uint32_t, 3>> cutPolygon(const std::vector<Vector3>& corners)
{
  const auto size = static_cast<int>(corners.size());
  auto triangles = meshing::isConvex(corners) ? std::nullopt : meshing::triangulate(corners);
  if (triangles)
  {
    return *triangles;
  }
  vtkNew<vtkPolygon> shape;
  shape->GetPoints()->SetDataTypeToDouble();
  shape->GetPointIds()->SetNumberOfIds(size);
  shape->GetPoints()->SetNumberOfPoints(size);
  for (int i = 0; i < size; ++i)
  {
    shape->GetPointIds()->SetId(i, i);
    shape->GetPoints()->SetPoint(i, corners[i].data());
  }
  vtkNew<vtkIdList> ids;
  shape->Triangulate(ids);
  std::vector<std::array<std::uint32_t, 3>> cut;
  for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
  {
    const auto number = [&](vtkIdType k) { return static_cast<std::uint32_t>(ids->GetId(i + k)); };
    cut.push_back({number(0), number(1), number(2)});
  }
  return cut;
}

/** Triangles of one polygon, which may be concave and have holes. */
std::vector<Triangle> trianglesOf(const Mesh& mesh, std::size_t polygon)
{
  std::vector<Vector3> corners;
  for (std::int64_t i = mesh.begin(polygon); i < mesh.ends[polygon]; ++i)
  {
    corners.push_back(mesh.points[mesh.corners[i]]);
  }
  if (corners.size() == 3)
  {
    return {{corners[0], corners[1], corners[2]}};
  }
  const Vector3 normal = mesh.area(polygon);
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : cutPolygon(corners))
  {
    Triangle t{corners[a], corners[b], corners[c]};
    // Ear cutting does not promise the polygon's own winding.
    if (dot(cross(t[1] - t[0], t[2] - t[0]), normal) < 0.0)
    {
      std::swap(t[1], t[2]);
    }
    triangles.push_back(t);
  }
  return triangles;
}

/** Index of the corner opposite the longest edge, and that edge's length. */
std::pair<int, double> longestEdge(const Triangle& t)
{
  std::pair<int, double> longest{0, 0.0};
  for (int i = 0; i < 3; ++i)
  {
    const double length = norm(t[(i + 2) % 3] - t[(i + 1) % 3]);
    if (length > longest.second)
    {
      longest = {i, length};
    }
  }
  return longest;
}

[[noreturn]] void failTooMany(std::int64_t most)
{
  throw std::length_error("a longer edge: " + fewerReceivers(most));
}

class Output
{
public:
  explicit Output(std::int64_t most) : Most(most)
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
  }

  void add(const Triangle& t, bool flip)
  {
    if (this->Triangles->GetNumberOfCells() >= this->Most)
    {
      failTooMany(this->Most);
    }
    const Vector3 area = cross(t[1] - t[0], t[2] - t[0]);
    const Vector3 normal = ((flip ? -1.0 : 1.0) / norm(area)) * area;
    vtkIdType ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = this->Points->InsertNextPoint(t[flip ? 2 - i : i].data());
    }
    this->Triangles->InsertNextCell(3, ids);
    this->Normals->InsertNextTuple(normal.data());
  }

  vtkSmartPointer<vtkPolyData> data()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    data->SetPolys(this->Triangles);
    data->GetCellData()->SetNormals(this->Normals);
    return data;
  }

private:
  std::int64_t Most;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  vtkNew<vtkDoubleArray> Normals;
};
}  // namespace

vtkSmartPointer<vtkPolyData> makeSurfaceReceivers(const Mesh& mesh, double edgeLength, bool flip, std::int64_t most)
{
  // The equilateral triangle is the largest one, so a count that is too high is known in advance.
  double area = 0.0;
  for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
  {
    area += norm(mesh.area(p));
  }
  if (area > 0.433 * edgeLength * edgeLength * static_cast<double>(most))
  {
    failTooMany(most);
  }

  Output output(most);
  for (std::size_t p = 0; p < mesh.numberOfPolygons(); ++p)
  {
    std::vector<Triangle> work = trianglesOf(mesh, p);
    while (!work.empty())
    {
      const Triangle t = work.back();
      work.pop_back();
      const auto [apex, length] = longestEdge(t);
      if (length <= edgeLength)
      {
        output.add(t, flip);
        continue;
      }
      const Vector3& a = t[apex];
      const Vector3& b = t[(apex + 1) % 3];
      const Vector3& c = t[(apex + 2) % 3];
      const Vector3 middle = 0.5 * (b + c);
      work.push_back({a, middle, c});
      work.push_back({a, b, middle});
      // Below the resolution of the coordinates, halving would never end.
      if (work.size() > 4096)
      {
        throw std::length_error("a longer edge: this one cannot be reached at these coordinates");
      }
    }
  }
  return output.data();
}
}  // namespace kalos::scene
