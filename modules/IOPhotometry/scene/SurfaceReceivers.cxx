// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceReceivers.h"

#include <algorithm>
#include <stdexcept>

#include "SceneReceivers.h"
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

/** Triangles of one polygon, which may be concave. */
std::vector<Triangle> triangulate(const Mesh& mesh, std::size_t polygon)
{
  const std::int64_t begin = mesh.begin(polygon);
  const auto size = static_cast<int>(mesh.ends[polygon] - begin);
  std::vector<Triangle> triangles;
  const auto corner = [&](vtkIdType i) { return mesh.points[mesh.corners[begin + i]]; };
  if (size == 3)
  {
    triangles.push_back({corner(0), corner(1), corner(2)});
    return triangles;
  }
  vtkNew<vtkPolygon> shape;
  shape->GetPoints()->SetDataTypeToDouble();
  shape->GetPointIds()->SetNumberOfIds(size);
  shape->GetPoints()->SetNumberOfPoints(size);
  for (int i = 0; i < size; ++i)
  {
    shape->GetPointIds()->SetId(i, i);
    shape->GetPoints()->SetPoint(i, corner(i).data());
  }
  vtkNew<vtkIdList> ids;
  shape->Triangulate(ids);
  const Vector3 normal = mesh.area(polygon);
  for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
  {
    Triangle t{corner(ids->GetId(i)), corner(ids->GetId(i + 1)), corner(ids->GetId(i + 2))};
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
  // No triangle is larger than the equilateral one: tell before the work what cannot work.
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
    std::vector<Triangle> work = triangulate(mesh, p);
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
      // A length below the coordinates' resolution would halve for ever.
      if (work.size() > 4096)
      {
        throw std::length_error("a longer edge: this one cannot be reached at these coordinates");
      }
    }
  }
  return output.data();
}
}  // namespace kalos::scene
