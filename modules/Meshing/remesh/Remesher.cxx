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

/// Reports now and then what is done, from within CGAL, which may stay in one iteration for ever.
class Watch
{
public:
  explicit Watch(const Progress& progress) : progress_(progress) {}
  void setShare(double share) { report(progress_, share_ = share); }
  void look()
  {
    if (++looks_ % 65536 == 0)
      report(progress_, share_);
  }

private:
  const Progress& progress_;
  double share_ = 0.0;
  std::size_t looks_ = 0;
};

/// The marks of kept edges, which CGAL asks for wherever it works.
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

class Remesher::Work
{
public:
  Work(const TriangleMesh& input, std::vector<std::uint8_t> turned, const Progress& progress)
      : input_(input), turned_(std::move(turned)), watch_(progress)
  {
    for (const Point& p : input.points)
      mesh_.add_vertex({p[0], p[1], p[2]});
    for (const Triangle& t : input.triangles)
    {
      if (mesh_.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == SurfaceMesh::null_face())
        throw std::invalid_argument("cell " + std::to_string(input.origin[mesh_.number_of_faces()]) +
                                    " cannot be joined to its neighbours; expected a surface that was repaired");
    }
    keptEdge_ = mesh_.add_property_map<Edge, bool>("e:kept", false).first;
    keptVertex_ = mesh_.add_property_map<Vertex, bool>("v:kept", false).first;
    patch_ = mesh_.add_property_map<Face, std::size_t>("f:patch", 0).first;
  }

  /// Mark what must stay, and number the patches in between.
  std::size_t findPatches(double feature)
  {
    for (const Edge e : mesh_.edges())
      keptEdge_[e] = this->isFeature(e, feature);
    for (const Vertex v : mesh_.vertices())
      keptVertex_[v] = this->isBend(v);
    const std::size_t patches =
        pmp::connected_components(mesh_, patch_, CGAL::parameters::edge_is_constrained_map(keptEdge_));
    trianglesOf_.resize(patches);
    for (const Face f : mesh_.faces())
      trianglesOf_[patch_[f]].push_back(f.idx());
    return patches;
  }

  void setShare(double share) { watch_.setShare(share); }

  void iterate(double length) { this->iterate(mesh_.faces(), length); }

  /// Remesh only where the wanted length at the triangle's centre is below `limit`.
  void iterateWhere(const std::function<double(const Point&)>& wanted, double limit, double length)
  {
    std::vector<Face> faces;
    std::vector<std::uint8_t> chosen(mesh_.number_of_faces() + mesh_.number_of_removed_faces(), 0);
    for (const Face f : mesh_.faces())
    {
      if (wanted(this->centre(f)) < limit)
      {
        faces.push_back(f);
        chosen[f.idx()] = 1;
      }
    }
    // The rim of the chosen part stays for now.
    std::vector<Vertex> rim;
    for (const Edge e : mesh_.edges())
    {
      const HalfEdge h = mesh_.halfedge(e);
      if (mesh_.is_border(e) || chosen[mesh_.face(h).idx()] == chosen[mesh_.face(mesh_.opposite(h)).idx()])
        continue;
      for (const Vertex v : {mesh_.source(h), mesh_.target(h)})
      {
        if (!keptVertex_[v])
        {
          keptVertex_[v] = true;
          rim.push_back(v);
        }
      }
    }
    this->iterate(faces, length);
    for (const Vertex v : rim)
      keptVertex_[v] = false;
  }

  TriangleMesh result()
  {
    mesh_.collect_garbage();
    TriangleMesh output;
    for (const Vertex v : mesh_.vertices())
      output.points.push_back(point(mesh_.point(v)));
    std::vector<std::vector<Face>> facesOf(trianglesOf_.size());
    for (const Face f : mesh_.faces())
      facesOf[patch_[f]].push_back(f);
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
    pmp::isotropic_remeshing(faces, length, mesh_,
                             CGAL::parameters::number_of_iterations(1)
                                 .edge_is_constrained_map(WatchedMarks{keptEdge_, &watch_})
                                 .vertex_is_constrained_map(keptVertex_)
                                 .face_patch_map(patch_)
                                 .relax_constraints(false));
  }

  bool isFeature(Edge e, double feature) const
  {
    if (mesh_.is_border(e))
      return true;
    const std::size_t a = mesh_.face(mesh_.halfedge(e)).idx();
    const std::size_t b = mesh_.face(mesh_.opposite(mesh_.halfedge(e))).idx();
    if (input_.material[a] != input_.material[b] || turned_[a] != turned_[b])
      return true;
    const Point na = doubledArea(input_, input_.triangles[a]), nb = doubledArea(input_, input_.triangles[b]);
    return std::atan2(norm(cross(na, nb)), dot(na, nb)) > feature;
  }

  /// Whether kept lines end, branch or bend here.
  bool isBend(Vertex v) const
  {
    std::vector<Point> directions;
    for (const HalfEdge h : CGAL::halfedges_around_target(v, mesh_))
    {
      if (keptEdge_[mesh_.edge(h)])
        directions.push_back(unit(point(mesh_.point(mesh_.source(h))) - point(mesh_.point(v))));
    }
    if (directions.empty())
      return false;
    return directions.size() != 2 || norm(directions[0] + directions[1]) > 1e-5;
  }

  Point centre(Face f) const
  {
    Point sum{0, 0, 0};
    for (const Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
      sum = sum + point(mesh_.point(v));
    return (1.0 / 3.0) * sum;
  }

  /// Append a patch's triangles, each with the origin of the nearest triangle that the patch had.
  void appendPatch(std::size_t patch, const std::vector<Face>& faces, TriangleMesh& output) const
  {
    const std::vector<std::uint32_t>& before = trianglesOf_[patch];
    const bool oneOrigin = std::all_of(before.begin(), before.end(), [&](std::uint32_t t) {
      return input_.origin[t] == input_.origin[before.front()];
    });
    std::unique_ptr<NearestTriangle> tree;
    if (!oneOrigin)
      tree = std::make_unique<NearestTriangle>(input_, before);
    for (const Face f : faces)
    {
      const std::uint32_t nearest = tree ? tree->to(this->centre(f)) : before.front();
      Triangle corners{};
      int k = 0;
      for (const Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        corners[k++] = v.idx();
      if (turned_[before.front()])
        std::swap(corners[0], corners[2]);
      output.triangles.push_back(corners);
      output.origin.push_back(input_.origin[nearest]);
      output.material.push_back(input_.material[nearest]);
    }
  }

  const TriangleMesh& input_;
  std::vector<std::uint8_t> turned_;
  Watch watch_;
  SurfaceMesh mesh_;
  SurfaceMesh::Property_map<Edge, bool> keptEdge_;
  SurfaceMesh::Property_map<Vertex, bool> keptVertex_;
  SurfaceMesh::Property_map<Face, std::size_t> patch_;
  std::vector<std::vector<std::uint32_t>> trianglesOf_;  // of the input, by patch
};

Remesher::Remesher(const TriangleMesh& input, std::vector<std::uint8_t> turned, const Progress& progress)
    : work_(std::make_unique<Work>(input, std::move(turned), progress))
{
}

Remesher::~Remesher() = default;

void Remesher::setShare(double share)
{
  work_->setShare(share);
}

std::size_t Remesher::findPatches(double feature)
{
  return work_->findPatches(feature);
}

void Remesher::iterate(double length)
{
  work_->iterate(length);
}

void Remesher::iterateWhere(const std::function<double(const Point&)>& wanted, double limit, double length)
{
  work_->iterateWhere(wanted, limit, length);
}

TriangleMesh Remesher::result()
{
  return work_->result();
}
}  // namespace kalos::meshing
