// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMeshes.h"

#include "GltfAccessor.h"

namespace kalos::scene
{
namespace
{
enum Mode
{
  Triangles = 4,
  Strip = 5,
  Fan = 6
};

/** The corners of all triangles of a primitive, from the order of its points. */
std::vector<std::array<std::uint32_t, 3>> Assemble(const JsonCursor& primitive, int mode,
                                                   const std::vector<std::uint32_t>& order)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (order.size() < 3 || (mode == Triangles && order.size() % 3 != 0))
  {
    primitive.Fail(std::to_string(order.size()) + " corners; expected " +
                   (mode == Triangles ? "three for each triangle" : "at least 3"));
  }
  if (mode == Triangles)
  {
    for (std::size_t i = 0; i + 2 < order.size(); i += 3)
    {
      triangles.push_back({order[i], order[i + 1], order[i + 2]});
    }
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < order.size(); ++i)
  {
    // Every second triangle of a strip has its corners the other way round.
    const std::size_t odd = i % 2;
    triangles.push_back(mode == Strip ? std::array<std::uint32_t, 3>{order[i], order[i + 1 + odd], order[i + 2 - odd]}
                                      : std::array<std::uint32_t, 3>{order[i + 1], order[i + 2], order[0]});
  }
  return triangles;
}

Transform FromParts(const Vector3& translation, const std::array<double, 4>& q, const Vector3& scale)
{
  const double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const double s = length > 0.0 ? 2.0 / length : 0.0;
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  Transform map;
  map.Axes[0] = scale[0] * Vector3{1.0 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)};
  map.Axes[1] = scale[1] * Vector3{s * (x * y - z * w), 1.0 - s * (x * x + z * z), s * (y * z + x * w)};
  map.Axes[2] = scale[2] * Vector3{s * (x * z + y * w), s * (y * z - x * w), 1.0 - s * (x * x + y * y)};
  map.Origin = translation;
  return map;
}

std::vector<double> Numbers(const JsonCursor& array, std::size_t count)
{
  std::vector<double> numbers;
  for (const JsonCursor& item : array.Items())
  {
    numbers.push_back(item.Number());
  }
  if (numbers.size() != count)
  {
    array.FailExpected(std::to_string(count) + " numbers");
  }
  return numbers;
}

Transform FromMatrix(const JsonCursor& matrix)
{
  const std::vector<double> m = Numbers(matrix, 16);
  if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
  {
    matrix.Fail("a projection; expected 0, 0, 0, 1 in the last row");
  }
  Transform map;
  map.Axes = {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
  map.Origin = {m[12], m[13], m[14]};
  return map;
}
}  // namespace

void GltfMeshes::ReadPrimitive(const JsonCursor& primitive, const std::string& name, GltfMesh& mesh)
{
  const auto given = primitive.Find("mode");
  const int mode = given ? given->Integer(0, 6) : Triangles;
  const auto position = primitive.At("attributes").Find("POSITION");
  if (mode < Triangles || !position)
  {
    this->Found.Count("meshes of points or lines", name, "left out", "they have no area");
    return;
  }
  if (primitive.Has("targets"))
  {
    this->Found.Count("morphed meshes", name, "in their first shape", "nothing moves here");
  }
  const std::vector<Vector3> points = ReadPoints(this->File, *position);
  std::vector<std::uint32_t> order;
  if (const auto indices = primitive.Find("indices"))
  {
    order = ReadIndices(this->File, *indices);
    for (const std::uint32_t i : order)
    {
      if (i >= points.size())
      {
        indices->Fail("point " + std::to_string(i) + " is named; expected one of the " + std::to_string(points.size()));
      }
    }
  }
  else
  {
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
      order.push_back(i);
    }
  }
  const auto number = primitive.Find("material");
  const std::int32_t material = number ? static_cast<std::int32_t>(this->File.Index(*number, "materials")) : -1;
  const auto triangles = Assemble(primitive, mode, order);
  if (mesh.Triangles.size() + triangles.size() > MaximumTriangles ||
      mesh.Points.size() + points.size() > 3 * MaximumTriangles)
  {
    primitive.Fail("too many triangles or points in one mesh; expected at most " + std::to_string(MaximumTriangles) +
                   " triangles with three points each");
  }
  const auto first = static_cast<std::uint32_t>(mesh.Points.size());
  for (const auto& t : triangles)
  {
    mesh.Triangles.push_back({first + t[0], first + t[1], first + t[2]});
    mesh.MaterialOf.push_back(material);
  }
  mesh.Points.insert(mesh.Points.end(), points.begin(), points.end());
}

const GltfMesh& GltfMeshes::Read(const JsonCursor& number)
{
  const std::size_t index = this->File.Index(number, "meshes");
  const auto known = this->Known.find(index);
  if (known != this->Known.end())
  {
    return known->second;
  }
  const JsonCursor& node = this->File.Section("meshes")[index];
  const std::string name = node.Has("name") ? node.At("name").String() : node.Where();
  GltfMesh mesh;
  for (const JsonCursor& primitive : node.At("primitives").Items())
  {
    this->ReadPrimitive(primitive, name, mesh);
  }
  return this->Known[index] = std::move(mesh);
}

Transform ReadNodeTransform(const JsonCursor& node)
{
  if (const auto matrix = node.Find("matrix"))
  {
    return FromMatrix(*matrix);
  }
  const auto translation = node.Find("translation");
  const auto rotation = node.Find("rotation");
  const auto scale = node.Find("scale");
  std::array<double, 4> q{0.0, 0.0, 0.0, 1.0};
  if (rotation)
  {
    const std::vector<double> numbers = Numbers(*rotation, 4);
    std::copy(numbers.begin(), numbers.end(), q.begin());
  }
  return FromParts(translation ? translation->Vector() : Vector3{}, q,
                   scale ? scale->Vector() : Vector3{1.0, 1.0, 1.0});
}

std::vector<Transform> ReadInstances(const GltfFile& file, const JsonCursor& node)
{
  const auto extensions = node.Find("extensions");
  const auto instancing = extensions ? extensions->Find("EXT_mesh_gpu_instancing") : std::nullopt;
  if (!instancing)
  {
    return {Transform()};
  }
  const JsonCursor attributes = instancing->At("attributes");
  const auto read = [&](const char* key, const char* type) {
    const auto number = attributes.Find(key);
    return number ? ReadVectors(file, *number, type) : std::vector<double>();
  };
  const std::vector<double> places = read("TRANSLATION", "VEC3");
  const std::vector<double> turns = read("ROTATION", "VEC4");
  const std::vector<double> scales = read("SCALE", "VEC3");
  const std::size_t count = std::max({places.size() / 3, turns.size() / 4, scales.size() / 3});
  const auto fits = [count](std::size_t found) { return found == 0 || found == count; };
  if (!fits(places.size() / 3) || !fits(turns.size() / 4) || !fits(scales.size() / 3))
  {
    attributes.Fail("different numbers of instances; expected as many translations as rotations and scales");
  }
  std::vector<Transform> instances;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto vector = [i](const std::vector<double>& v, double absent) {
      return v.empty() ? Vector3{absent, absent, absent} : Vector3{v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    };
    std::array<double, 4> q{0.0, 0.0, 0.0, 1.0};
    if (!turns.empty())
    {
      std::copy(turns.begin() + static_cast<std::ptrdiff_t>(4 * i),
                turns.begin() + static_cast<std::ptrdiff_t>(4 * i + 4), q.begin());
    }
    instances.push_back(FromParts(vector(places, 0.0), q, vector(scales, 1.0)));
  }
  return instances;
}
}  // namespace kalos::scene
