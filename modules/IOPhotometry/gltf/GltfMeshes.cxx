// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMeshes.h"

#include <algorithm>
#include <cmath>

#include "GltfAccessor.h"

namespace kalos::scene
{
namespace
{
constexpr double LastRowRounding = 1e-5;

enum Mode
{
  Triangles = 4,
  Strip = 5,
  Fan = 6
};

/** The corners of all triangles of a primitive, from the order of its points. */
std::vector<std::array<std::uint32_t, 3>> assemble(const JsonCursor& primitive, int mode,
                                                   const std::vector<std::uint32_t>& order)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (order.size() < 3 || (mode == Triangles && order.size() % 3 != 0))
  {
    primitive.fail(std::to_string(order.size()) + " corners; expected " +
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

/** The numbers of points in the order of the corners. */
std::vector<std::uint32_t> readOrder(const GltfFile& file, const JsonCursor& primitive, std::size_t points)
{
  std::vector<std::uint32_t> order;
  if (const auto indices = primitive.find("indices"))
  {
    order = readIndices(file, *indices);
    for (const std::uint32_t i : order)
    {
      if (i >= points)
      {
        indices->fail("point " + std::to_string(i) + " is named; expected one of the " + std::to_string(points));
      }
    }
    return order;
  }
  for (std::uint32_t i = 0; i < points; ++i)
  {
    order.push_back(i);
  }
  return order;
}

Transform fromParts(const Vector3& translation, const std::array<double, 4>& q, const Vector3& scale)
{
  const double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const double s = length > 0.0 ? 2.0 / length : 0.0;
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  Transform map;
  map.axes[0] = scale[0] * Vector3{1.0 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w)};
  map.axes[1] = scale[1] * Vector3{s * (x * y - z * w), 1.0 - s * (x * x + z * z), s * (y * z + x * w)};
  map.axes[2] = scale[2] * Vector3{s * (x * z + y * w), s * (y * z - x * w), 1.0 - s * (x * x + y * y)};
  map.origin = translation;
  return map;
}

std::vector<double> readNumbers(const JsonCursor& array, std::size_t count)
{
  std::vector<double> numbers;
  for (const JsonCursor& item : array.items())
  {
    numbers.push_back(item.number());
  }
  if (numbers.size() != count)
  {
    array.failExpected(std::to_string(count) + " numbers");
  }
  return numbers;
}

Transform fromMatrix(const JsonCursor& matrix)
{
  const std::vector<double> m = readNumbers(matrix, 16);
  // Matrix products in single precision leave small errors in the last row.
  const double off = std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1.0)});
  if (!(off <= LastRowRounding))
  {
    matrix.fail("a projection; expected 0, 0, 0, 1 in the last row");
  }
  Transform map;
  map.axes = {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
  map.origin = {m[12], m[13], m[14]};
  return map;
}
}  // namespace

void GltfMeshes::readPrimitive(const JsonCursor& primitive, const std::string& name, GltfMesh& mesh)
{
  const auto given = primitive.find("mode");
  const int mode = given ? given->integer(0, 6) : Triangles;
  const auto position = primitive.at("attributes").find("POSITION");
  if (mode < Triangles || !position)
  {
    this->Found.count("meshes of points or lines", name, "left out", "they have no area");
    return;
  }
  if (primitive.has("targets"))
  {
    this->Found.count("morphed meshes", name, "in their first shape", "nothing moves here");
  }
  this->refuseCompression(primitive, *position);
  const std::vector<Vector3> points = readPoints(this->File, *position);
  const std::vector<std::uint32_t> order = readOrder(this->File, primitive, points.size());
  const auto number = primitive.find("material");
  const std::int32_t material = number ? static_cast<std::int32_t>(this->File.index(*number, "materials")) : -1;
  const auto triangles = assemble(primitive, mode, order);
  if (mesh.triangles.size() + triangles.size() > MaximumTriangles ||
      mesh.points.size() + points.size() > 3 * MaximumTriangles)
  {
    primitive.fail("too many triangles or points in one mesh; expected at most " + std::to_string(MaximumTriangles) +
                   " triangles with three points each");
  }
  this->readColors(primitive, name, triangles, mesh);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const auto& t : triangles)
  {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    mesh.materialOf.push_back(material);
  }
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
}

void GltfMeshes::refuseCompression(const JsonCursor& primitive, const JsonCursor& position) const
{
  const auto extensions = primitive.find("extensions");
  const bool compressed = extensions && extensions->has("KHR_draco_mesh_compression");
  if (compressed && !this->File.element(position, "accessors").has("bufferView"))
  {
    primitive.fail("its points are compressed (KHR_draco_mesh_compression); expected a file without compression");
  }
}

/** Reads COLOR_0 for the triangles that follow; triangles without it are white if others have it. */
void GltfMeshes::readColors(const JsonCursor& primitive, const std::string& name,
                            const std::vector<std::array<std::uint32_t, 3>>& triangles, GltfMesh& mesh)
{
  const std::size_t before = mesh.triangles.size();
  const auto number = primitive.at("attributes").find("COLOR_0");
  if (!number)
  {
    mesh.colorOf.resize(mesh.colorOf.empty() ? 0 : before + triangles.size(), {1.0, 1.0, 1.0});
    return;
  }
  const std::string type = this->File.element(*number, "accessors").at("type").string();
  const std::size_t size = type == "VEC4" ? 4 : 3;
  const std::vector<double> colors = readVectors(this->File, *number, type == "VEC4" ? "VEC4" : "VEC3");
  mesh.colorOf.resize(before, {1.0, 1.0, 1.0});
  for (const auto& triangle : triangles)
  {
    std::array<double, 3> mean{};
    for (const std::uint32_t point : triangle)
    {
      if (size * point + 3 > colors.size())
      {
        number->fail("fewer colours than points; expected as many");
      }
      for (int c = 0; c < 3; ++c)
      {
        mean[c] += std::clamp(colors[size * point + c], 0.0, 1.0) / 3.0;
      }
    }
    mesh.colorOf.push_back(mean);
  }
  this->Found.count("colours of points", name, "the mean of each triangle", "they multiply the base colour");
}

const GltfMesh& GltfMeshes::read(const JsonCursor& number)
{
  const std::size_t index = this->File.index(number, "meshes");
  const auto known = this->Known.find(index);
  if (known != this->Known.end())
  {
    return known->second;
  }
  const JsonCursor& node = this->File.section("meshes")[index];
  const std::string name = node.has("name") ? node.at("name").string() : node.where();
  GltfMesh mesh;
  for (const JsonCursor& primitive : node.at("primitives").items())
  {
    this->readPrimitive(primitive, name, mesh);
  }
  return this->Known[index] = std::move(mesh);
}

Transform readNodeTransform(const JsonCursor& node)
{
  if (const auto matrix = node.find("matrix"))
  {
    return fromMatrix(*matrix);
  }
  const auto translation = node.find("translation");
  const auto rotation = node.find("rotation");
  const auto scale = node.find("scale");
  std::array<double, 4> q{0.0, 0.0, 0.0, 1.0};
  if (rotation)
  {
    const std::vector<double> numbers = readNumbers(*rotation, 4);
    std::copy(numbers.begin(), numbers.end(), q.begin());
  }
  return fromParts(translation ? translation->vector() : Vector3{}, q,
                   scale ? scale->vector() : Vector3{1.0, 1.0, 1.0});
}

std::vector<Transform> readInstances(const GltfFile& file, const JsonCursor& node)
{
  const auto extensions = node.find("extensions");
  const auto instancing = extensions ? extensions->find("EXT_mesh_gpu_instancing") : std::nullopt;
  if (!instancing)
  {
    return {Transform()};
  }
  const JsonCursor attributes = instancing->at("attributes");
  const auto read = [&](const char* key, const char* type) {
    const auto number = attributes.find(key);
    return number ? readVectors(file, *number, type) : std::vector<double>();
  };
  const std::vector<double> places = read("TRANSLATION", "VEC3");
  const std::vector<double> turns = read("ROTATION", "VEC4");
  const std::vector<double> scales = read("SCALE", "VEC3");
  const std::size_t count = std::max({places.size() / 3, turns.size() / 4, scales.size() / 3});
  const auto fits = [count](std::size_t found) { return found == 0 || found == count; };
  if (!fits(places.size() / 3) || !fits(turns.size() / 4) || !fits(scales.size() / 3))
  {
    attributes.fail("different numbers of instances; expected as many translations as rotations and scales");
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
    instances.push_back(fromParts(vector(places, 0.0), q, vector(scales, 1.0)));
  }
  return instances;
}
}  // namespace kalos::scene
