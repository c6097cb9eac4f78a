// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "../base/InputError.h"

namespace kalos::scene
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

bool isFinite(const Vector3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}
}  // namespace

void Mesh::addPolygon(const std::vector<std::int64_t>& numbers, std::int32_t material)
{
  this->corners.insert(this->corners.end(), numbers.begin(), numbers.end());
  this->ends.push_back(static_cast<std::int64_t>(this->corners.size()));
  this->materialOf.push_back(material);
}

Vector3 Mesh::area(std::size_t polygon) const
{
  // Sum of the fan's triangles about the first corner; right for concave polygons too.
  const std::int64_t begin = this->begin(polygon);
  const Vector3& apex = this->points[this->corners[begin]];
  Vector3 area{};
  for (std::int64_t i = begin + 1; i + 1 < this->ends[polygon]; ++i)
  {
    const Vector3 a = this->points[this->corners[i]] - apex;
    const Vector3 b = this->points[this->corners[i + 1]] - apex;
    area = area + 0.5 * cross(a, b);
  }
  return area;
}

bool Mesh::hasArea(std::size_t polygon) const
{
  const std::int64_t begin = this->begin(polygon), end = this->ends[polygon];
  double perimeter = 0.0;
  for (std::int64_t i = begin; i < end; ++i)
  {
    const std::int64_t next = this->corners[i + 1 == end ? begin : i + 1];
    perimeter += norm(this->points[next] - this->points[this->corners[i]]);
  }
  // Relative, so that a millimetre part and a stadium are judged alike.
  return end - begin > 2 && norm(this->area(polygon)) > 1e-13 * perimeter * perimeter;
}

void Mesh::takeMaterials(const std::vector<Material>& all)
{
  std::map<std::int32_t, std::int32_t> numbers;
  for (std::int32_t& material : this->materialOf)
  {
    const auto [known, added] = numbers.emplace(material, static_cast<std::int32_t>(this->palette.size()));
    if (added)
    {
      this->palette.push_back(all[material]);
    }
    material = known->second;
  }
}

std::size_t Mesh::dropDegenerate()
{
  const Mesh all = *this;
  this->corners.clear();
  this->ends.clear();
  this->materialOf.clear();
  for (std::size_t p = 0; p < all.numberOfPolygons(); ++p)
  {
    if (all.hasArea(p))
    {
      this->addPolygon({all.corners.begin() + all.begin(p), all.corners.begin() + all.ends[p]}, all.materialOf[p]);
    }
  }
  return all.numberOfPolygons() - this->numberOfPolygons();
}

void Mesh::check(const std::string& file, const char* face) const
{
  for (std::size_t p = 0; p < this->numberOfPolygons(); ++p)
  {
    const std::int64_t begin = this->begin(p);
    const std::int64_t end = this->ends[p];
    const auto fail = [&](const std::string& what) {
      throw InputError(file, face + (" " + std::to_string(p + 1)), what);
    };
    for (std::int64_t i = begin; i < end; ++i)
    {
      const std::int64_t corner = this->corners[i];
      if (corner < 0 || corner >= static_cast<std::int64_t>(this->points.size()))
      {
        fail("a corner is point " + std::to_string(corner) + "; expected one of the " +
             std::to_string(this->points.size()) + " points of the file");
      }
      if (!isFinite(this->points[corner]))
      {
        fail("a corner has a coordinate that is not finite; expected metres");
      }
    }
  }
}

void noteDegenerate(std::size_t count, Notes& notes)
{
  if (count > 0)
  {
    notes.push_back({"degenerate faces", "left out", "they have no area (" + std::to_string(count) + ")"});
  }
}

Mesh makeQuad(const Vector3& origin, const Vector3& u, const Vector3& v)
{
  Mesh mesh;
  mesh.points = {origin, origin + u, origin + u + v, origin + v};
  mesh.addPolygon({0, 1, 2, 3}, -1);
  return mesh;
}

Mesh makeBox(const Vector3& center, const Vector3& size, double rotationZDegrees)
{
  Mesh mesh;
  const double c = std::cos(rotationZDegrees * Pi / 180.0);
  const double s = std::sin(rotationZDegrees * Pi / 180.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const double x = ((corner & 1) ? 0.5 : -0.5) * size[0];
    const double y = ((corner & 2) ? 0.5 : -0.5) * size[1];
    const double z = ((corner & 4) ? 0.5 : -0.5) * size[2];
    mesh.points.push_back(center + Vector3{c * x - s * y, s * x + c * y, z});
  }
  // Bottom, top, front (-y), back, left (-x), right; anti-clockwise seen from outside.
  for (const auto& face :
       {std::vector<std::int64_t>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
  {
    mesh.addPolygon(face, -1);
  }
  return mesh;
}
}  // namespace kalos::scene
