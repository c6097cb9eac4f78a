// SPDX-License-Identifier: BSD-3-Clause
#include "singular/MeshEdges.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/vector_cast.hh>
#include <algorithm>
#include <cmath>

#include "mesh/SortedSides.h"
#include "singular/EdgeAngles.h"

namespace kalos::meshing
{
namespace
{
constexpr double pi = 3.14159265358979323846;

struct DoubleTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  // Half-edges and faces are only added: no status bits.
  HalfedgeAttributes(OpenMesh::Attributes::None);
  VertexAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
  EdgeAttributes(OpenMesh::Attributes::None);
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

class Classifier
{
public:
  Classifier(const TriangleMesh& mesh, const EdgeSettings& settings, EdgeReport& report, std::vector<Segment>& segments)
      : Mesh(mesh), Settings(settings), Report(report), Segments(segments)
  {
  }

  void add(std::uint32_t a, std::uint32_t b, const std::uint32_t* triangles, std::size_t count)
  {
    Segment segment{Mesh.points[a], Mesh.points[b], {}};
    EdgeProperties& edge = segment.edge;
    edge.kind = count == 1 ? EdgeClass::Border : count == 2 ? EdgeClass::Coplanar : EdgeClass::NonManifold;
    const Point axis = unit(segment.end - segment.start);
    Sheets.clear();
    for (std::size_t i = 0; i < count; ++i)
      Sheets.push_back(this->sheet(triangles[i], a, b, axis));
    const EdgeAngles angles = measureAngles(axis, Sheets, Settings.flat);
    edge.front = angles.front;
    edge.back = angles.back;
    Report.inconsistent += count == 2 && angles.mixed;
    classify(edge, Settings);
    ++Report.edges[static_cast<int>(edge.kind)];
    if (Settings.wanted[static_cast<int>(edge.kind)])
      Segments.push_back(segment);
  }

private:
  Sheet sheet(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, const Point& axis) const
  {
    const Triangle& corners = Mesh.triangles[triangle];
    const auto third = std::find_if(corners.begin(), corners.end(), [=](std::uint32_t c) { return c != a && c != b; });
    const Point away = Mesh.points[*third] - Mesh.points[a];
    return {unit(away - dot(away, axis) * axis), unit(doubledArea(Mesh, corners))};
  }

  const TriangleMesh& Mesh;
  const EdgeSettings& Settings;
  EdgeReport& Report;
  std::vector<Segment>& Segments;
  std::vector<Sheet> Sheets;
};

/// Suppresses OpenMesh's messages about faces that it rejects.
struct Quiet
{
  Quiet() { omerr().disable(); }
  ~Quiet() { omerr().enable(); }
};

/// Half-edge mesh of the marked triangles; the marks of those that it refuses (bow-tie vertices) are cleared.
HalfEdgeMesh halfEdges(const TriangleMesh& mesh, std::vector<std::uint8_t>& marks,
                       std::vector<std::uint32_t>& triangleOf)
{
  Quiet quiet;
  HalfEdgeMesh result;
  result.reserve(mesh.points.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  for (const Point& p : mesh.points)
    result.add_vertex({p[0], p[1], p[2]});
  std::vector<HalfEdgeMesh::VertexHandle> corners(3);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!marks[t])
      continue;
    for (int k = 0; k < 3; ++k)
      corners[k] = HalfEdgeMesh::VertexHandle(static_cast<int>(mesh.triangles[t][k]));
    if (result.add_face(corners).is_valid())
      triangleOf.push_back(t);
    else
      marks[t] = 0;
  }
  return result;
}
}  // namespace

void classify(EdgeProperties& edge, const EdgeSettings& settings)
{
  const double judged = settings.bothSides ? std::min(edge.front, edge.back) : edge.front;
  // Angles near zero belong to surfaces that lie on each other.
  edge.severity = judged > settings.flat && judged < pi - settings.flat ? severity(judged) : 0.0;
  if (edge.kind != EdgeClass::Coplanar)
    return;
  edge.kind = edge.severity > 0.0                      ? EdgeClass::Concave
              : std::abs(judged - pi) <= settings.flat ? EdgeClass::Coplanar
                                                       : EdgeClass::Convex;
}

void appendMeshEdges(const TriangleMesh& mesh, const EdgeSettings& settings, EdgeReport& report,
                     std::vector<Segment>& segments)
{
  // Triangles at an edge of three or more, or of two that disagree, cannot be stored in half-edges.
  const std::vector<Side> sides = sortedSides(mesh);
  std::vector<std::uint8_t> marks(mesh.triangles.size(), 1);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first > 2 || (last - first == 2 && sides[first].upwards == sides[first + 1].upwards))
    {
      for (std::size_t i = first; i < last; ++i)
        marks[sides[i].triangle] = 0;
    }
  });

  // Edges between two stored triangles: by half-edges.
  Classifier classifier(mesh, settings, report, segments);
  std::vector<std::uint32_t> triangleOf;
  {
    const HalfEdgeMesh stored = halfEdges(mesh, marks, triangleOf);
    for (const auto edge : stored.edges())
    {
      const auto halfEdge = stored.halfedge_handle(edge, 0);
      const auto left = stored.face_handle(halfEdge);
      const auto right = stored.face_handle(stored.opposite_halfedge_handle(halfEdge));
      if (!left.is_valid() || !right.is_valid())
        continue;
      const std::uint32_t triangles[2] = {triangleOf[left.idx()], triangleOf[right.idx()]};
      classifier.add(static_cast<std::uint32_t>(stored.from_vertex_handle(halfEdge).idx()),
                     static_cast<std::uint32_t>(stored.to_vertex_handle(halfEdge).idx()), triangles, 2);
    }
  }

  // All others: from the sorted sides.
  std::vector<std::uint32_t> around;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    around.clear();
    bool byHalfEdges = last - first == 2;
    for (std::size_t i = first; i < last; ++i)
    {
      around.push_back(sides[i].triangle);
      byHalfEdges = byHalfEdges && marks[sides[i].triangle];
    }
    if (!byHalfEdges)
      classifier.add(sides[first].low, sides[first].high, around.data(), around.size());
  });
}
}  // namespace kalos::meshing
