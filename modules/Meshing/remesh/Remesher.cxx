// SPDX-License-Identifier: BSD-3-Clause
#include "remesh/Remesher.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>

#include "mesh/NearestTriangle.h"

namespace kalos::meshing
{
namespace
{
namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = SurfaceMesh::Vertex_index;
using HalfEdge = SurfaceMesh::Halfedge_index;
using Edge = SurfaceMesh::Edge_index;
using Face = SurfaceMesh::Face_index;

Point point(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

/// Reports progress regularly from within CGAL, where one iteration may take very long.
class Watch
{
public:
  explicit Watch(const Progress& progress) : Told(progress) {}
  void setShare(double share) { report(Told, Share = share); }
  void look()
  {
    if (++Looks % 65536 == 0)
      report(Told, Share);
  }

private:
  const Progress& Told;
  double Share = 0.0;
  std::size_t Looks = 0;
};

/// The marks of kept edges. CGAL queries them all the time, so progress is reported here.
struct WatchedMarks
{
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  SurfaceMesh::Property_map<Edge, bool> marks;
  Watch* watch;

  friend bool get(const WatchedMarks& map, Edge e)
  {
    map.watch->look();
    return map.marks[e];
  }
  friend void put(const WatchedMarks& map, Edge e, bool mark) { map.marks[e] = mark; }
};
}  // namespace

class Remesher::Impl
{
public:
  Impl(const TriangleMesh& input, std::vector<std::uint8_t> turned, const Progress& progress)
      : Input(input), Turned(std::move(turned)), Watched(progress)
  {
    for (const Point& p : input.points)
      Mesh.add_vertex({p[0], p[1], p[2]});
    for (const Triangle& t : input.triangles)
    {
      if (Mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == SurfaceMesh::null_face())
        throw std::invalid_argument("cell " + std::to_string(input.origin[Mesh.number_of_faces()]) +
                                    " cannot be joined to its neighbours; expected a surface that was repaired");
    }
    KeptEdge = Mesh.add_property_map<Edge, bool>("e:kept", false).first;
    KeptVertex = Mesh.add_property_map<Vertex, bool>("v:kept", false).first;
    Patch = Mesh.add_property_map<Face, std::size_t>("f:patch", 0).first;
  }

  /// Mark what must stay, and number the patches in between.
  std::size_t findPatches(double feature)
  {
    for (const Edge e : Mesh.edges())
      KeptEdge[e] = this->isFeature(e, feature);
    for (const Vertex v : Mesh.vertices())
      KeptVertex[v] = this->isBend(v);
    const std::size_t patches =
        pmp::connected_components(Mesh, Patch, CGAL::parameters::edge_is_constrained_map(KeptEdge));
    TrianglesOf.resize(patches);
    for (const Face f : Mesh.faces())
      TrianglesOf[Patch[f]].push_back(f.idx());
    return patches;
  }

  void setShare(double share) { Watched.setShare(share); }

  void iterate(double length) { this->iterate(Mesh.faces(), length); }

  /// Remesh only where the wanted length at the triangle's centre is below `limit`.
  void iterateWhere(const std::function<double(const Point&)>& wanted, double limit, double length)
  {
    std::vector<Face> faces;
    std::vector<std::uint8_t> chosen(Mesh.number_of_faces() + Mesh.number_of_removed_faces(), 0);
    for (const Face f : Mesh.faces())
    {
      if (wanted(this->centre(f)) < limit)
      {
        faces.push_back(f);
        chosen[f.idx()] = 1;
      }
    }
    // The boundary of the chosen part is kept in this pass.
    std::vector<Vertex> rim;
    for (const Edge e : Mesh.edges())
    {
      const HalfEdge h = Mesh.halfedge(e);
      if (Mesh.is_border(e) || chosen[Mesh.face(h).idx()] == chosen[Mesh.face(Mesh.opposite(h)).idx()])
        continue;
      for (const Vertex v : {Mesh.source(h), Mesh.target(h)})
      {
        if (!KeptVertex[v])
        {
          KeptVertex[v] = true;
          rim.push_back(v);
        }
      }
    }
    this->iterate(faces, length);
    for (const Vertex v : rim)
      KeptVertex[v] = false;
  }

  TriangleMesh result()
  {
    Mesh.collect_garbage();
    TriangleMesh output;
    for (const Vertex v : Mesh.vertices())
      output.points.push_back(point(Mesh.point(v)));
    std::vector<std::vector<Face>> facesOf(TrianglesOf.size());
    for (const Face f : Mesh.faces())
      facesOf[Patch[f]].push_back(f);
    for (std::size_t p = 0; p < facesOf.size(); ++p)
      this->appendPatch(p, facesOf[p], output);
    dropUnusedPoints(output);
    return output;
  }

private:
  /// Kept lines are split and collapsed, but not smoothed: CGAL 5.5 would smooth their bends away, marked or not.
  template <typename Faces>
  void iterate(const Faces& faces, double length)
  {
    pmp::isotropic_remeshing(faces, length, Mesh,
                             CGAL::parameters::number_of_iterations(1)
                                 .edge_is_constrained_map(WatchedMarks{KeptEdge, &Watched})
                                 .vertex_is_constrained_map(KeptVertex)
                                 .face_patch_map(Patch)
                                 .relax_constraints(false));
  }

  bool isFeature(Edge e, double feature) const
  {
    if (Mesh.is_border(e))
      return true;
    const std::size_t a = Mesh.face(Mesh.halfedge(e)).idx();
    const std::size_t b = Mesh.face(Mesh.opposite(Mesh.halfedge(e))).idx();
    if (Input.material[a] != Input.material[b] || Turned[a] != Turned[b])
      return true;
    const Point na = doubledArea(Input, Input.triangles[a]), nb = doubledArea(Input, Input.triangles[b]);
    return std::atan2(norm(cross(na, nb)), dot(na, nb)) > feature;
  }

  /// Whether kept lines end, branch or bend here.
  bool isBend(Vertex v) const
  {
    std::vector<Point> directions;
    for (const HalfEdge h : CGAL::halfedges_around_target(v, Mesh))
    {
      if (KeptEdge[Mesh.edge(h)])
        directions.push_back(unit(point(Mesh.point(Mesh.source(h))) - point(Mesh.point(v))));
    }
    if (directions.empty())
      return false;
    return directions.size() != 2 || norm(directions[0] + directions[1]) > 1e-5;
  }

  Point centre(Face f) const
  {
    Point sum{0, 0, 0};
    for (const Vertex v : CGAL::vertices_around_face(Mesh.halfedge(f), Mesh))
      sum = sum + point(Mesh.point(v));
    return (1.0 / 3.0) * sum;
  }

  /// Append a patch's triangles, each with the origin of the nearest triangle that the patch had.
  void appendPatch(std::size_t patch, const std::vector<Face>& faces, TriangleMesh& output) const
  {
    const std::vector<std::uint32_t>& before = TrianglesOf[patch];
    const bool oneOrigin = std::all_of(
        before.begin(), before.end(), [&](std::uint32_t t) { return Input.origin[t] == Input.origin[before.front()]; });
    std::unique_ptr<NearestTriangle> tree;
    if (!oneOrigin)
      tree = std::make_unique<NearestTriangle>(Input, before);
    for (const Face f : faces)
    {
      const std::uint32_t nearest = tree ? tree->to(this->centre(f)) : before.front();
      Triangle corners{};
      int k = 0;
      for (const Vertex v : CGAL::vertices_around_face(Mesh.halfedge(f), Mesh))
        corners[k++] = v.idx();
      if (Turned[before.front()])
        std::swap(corners[0], corners[2]);
      output.triangles.push_back(corners);
      output.origin.push_back(Input.origin[nearest]);
      output.material.push_back(Input.material[nearest]);
    }
  }

  const TriangleMesh& Input;
  std::vector<std::uint8_t> Turned;
  Watch Watched;
  SurfaceMesh Mesh;
  SurfaceMesh::Property_map<Edge, bool> KeptEdge;
  SurfaceMesh::Property_map<Vertex, bool> KeptVertex;
  SurfaceMesh::Property_map<Face, std::size_t> Patch;
  std::vector<std::vector<std::uint32_t>> TrianglesOf;  // of the input, by patch
};

Remesher::Remesher(const TriangleMesh& input, std::vector<std::uint8_t> turned, const Progress& progress)
    : Work(std::make_unique<Impl>(input, std::move(turned), progress))
{
}

Remesher::~Remesher() = default;

void Remesher::setShare(double share)
{
  Work->setShare(share);
}

std::size_t Remesher::findPatches(double feature)
{
  return Work->findPatches(feature);
}

void Remesher::iterate(double length)
{
  Work->iterate(length);
}

void Remesher::iterateWhere(const std::function<double(const Point&)>& wanted, double limit, double length)
{
  Work->iterateWhere(wanted, limit, length);
}

TriangleMesh Remesher::result()
{
  return Work->result();
}
}  // namespace kalos::meshing
