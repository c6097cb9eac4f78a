// SPDX-License-Identifier: BSD-3-Clause
#include "remesh/SurfaceRemesh.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "repair/SurfaceRepair.h"
#include "singular/EdgeDistance.h"

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
using Triangles = std::vector<Kernel::Triangle_3>;
using TriangleTree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

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

/// The mesh in CGAL's form with what is to be kept.
class Remesher
{
public:
  Remesher(const TriangleMesh& input, std::vector<std::uint8_t> turned, Watch& watch)
      : input_(input), turned_(std::move(turned)), watch_(watch)
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

  SurfaceMesh::Face_range faces() const { return mesh_.faces(); }

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

  /// Remesh only where the wanted length at the triangle's centre is below `limit`.
  template <typename Wanted>
  void iterateWhere(const Wanted& wanted, double limit, double length)
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
    Triangles triangles;
    TriangleTree tree;
    if (!oneOrigin)
    {
      for (const std::uint32_t t : before)
      {
        const auto corner = [&](int k) {
          const Point& p = input_.points[input_.triangles[t][k]];
          return Kernel::Point_3(p[0], p[1], p[2]);
        };
        triangles.emplace_back(corner(0), corner(1), corner(2));
      }
      tree.insert(triangles.cbegin(), triangles.cend());
      tree.build();
    }
    for (const Face f : faces)
    {
      std::uint32_t nearest = before.front();
      if (!oneOrigin)
      {
        const Point c = this->centre(f);
        const auto found = tree.closest_point_and_primitive(Kernel::Point_3(c[0], c[1], c[2]));
        nearest = before[static_cast<std::size_t>(found.second - triangles.cbegin())];
      }
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
  Watch& watch_;
  SurfaceMesh mesh_;
  SurfaceMesh::Property_map<Edge, bool> keptEdge_;
  SurfaceMesh::Property_map<Vertex, bool> keptVertex_;
  SurfaceMesh::Property_map<Face, std::size_t> patch_;
  std::vector<std::vector<std::uint32_t>> trianglesOf_;  // of the input, by patch
};

/// What the input's cells want, found by place.
class CellWishes
{
public:
  CellWishes(const TriangleMesh& mesh, const std::vector<double>& wanted)
  {
    for (std::size_t t = 0; t < mesh.triangles.size() && !wanted.empty(); ++t)
    {
      const auto corner = [&](int k) {
        const Point& p = mesh.points[mesh.triangles[t][k]];
        return Kernel::Point_3(p[0], p[1], p[2]);
      };
      triangles_.emplace_back(corner(0), corner(1), corner(2));
      wishes_.push_back(wanted[mesh.origin[t]]);
      least_ = std::min(least_, wishes_.back());
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }
  double least() const { return least_; }
  double at(const Point& p) const
  {
    if (triangles_.empty())
      return std::numeric_limits<double>::infinity();
    const auto found = tree_.closest_point_and_primitive(Kernel::Point_3(p[0], p[1], p[2]));
    return wishes_[static_cast<std::size_t>(found.second - triangles_.cbegin())];
  }

private:
  Triangles triangles_;
  std::vector<double> wishes_;
  double least_ = std::numeric_limits<double>::infinity();
  TriangleTree tree_;
};

double lengthOf(const Curves& curves)
{
  double sum = 0.0;
  for (const Curve& c : curves.curves)
  {
    for (std::size_t i = c.first; i + 1 < c.first + c.count; ++i)
      sum += norm(curves.points[curves.indices[i + 1]] - curves.points[curves.indices[i]]);
  }
  return sum;
}

/// Bytes of memory of this machine; infinite where it cannot be told.
double physicalMemory()
{
#ifdef _SC_PHYS_PAGES
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
#else
  return std::numeric_limits<double>::infinity();
#endif
}

void refuseTooMany(double expected, std::size_t maximum)
{
  constexpr double bytesPerTriangle = 500;  // 410 measured
  const double held = physicalMemory() / bytesPerTriangle;
  const auto most = static_cast<double>(maximum);
  if (expected <= std::min(most, held))
    return;
  std::ostringstream text;
  text << std::setprecision(3) << "the edge length needs about " << expected << " triangles; expected one that needs "
       << (held < most ? "no more than the memory of this machine holds, " : "at most ") << std::min(most, held);
  throw std::invalid_argument(text.str());
}

void checkSettings(const TriangleMesh& mesh, const RemeshSettings& settings)
{
  const auto length = [](double l) { return l > 0.0 && std::isfinite(l); };
  if (!length(settings.edgeLength))
    throw std::invalid_argument("the edge length is not allowed; expected metres above 0");
  if (settings.smallest != 0.0 && (!length(settings.smallest) || !length(settings.grading)))
    throw std::invalid_argument("the smallest edge length or the grading is not allowed; expected numbers above 0");
  for (std::size_t t = 0; t < mesh.origin.size(); ++t)
  {
    if (mesh.origin[t] < settings.wanted.size() && !(settings.wanted[mesh.origin[t]] > 0.0))
      throw std::invalid_argument("the edge length that cell " + std::to_string(mesh.origin[t]) +
                                  " wants is not allowed; expected metres above 0");
  }
}
}  // namespace

RemeshReport remesh(TriangleMesh& mesh, const RemeshSettings& settings, const Progress& progress)
{
  check(mesh);
  checkSettings(mesh, settings);
  RemeshReport result;
  result.trianglesBefore = mesh.triangles.size();
  result.areaBefore = area(mesh);
  const bool graded = settings.smallest > 0.0 && settings.smallest < settings.edgeLength;
  const Curves curves = graded ? findSingularEdges(mesh, {}) : Curves();
  const double expected = expectedTriangles(mesh, settings, lengthOf(curves));
  refuseTooMany(expected, settings.maximumTriangles);
  Watch watch(progress);
  watch.setShare(0.05);

  std::vector<std::uint8_t> turned;
  orient(mesh, turned);
  Remesher remesher(mesh, std::move(turned), watch);
  result.patches = remesher.findPatches(settings.feature);

  // The wanted length anywhere, and the length of the finest level.
  const EdgeDistance edges(curves);
  const CellWishes wishes(mesh, settings.wanted);
  const auto wanted = [&](const Point& p) {
    const double byDistance = settings.smallest + settings.grading * edges.nearest(p).distance;
    return std::min(graded ? byDistance : settings.edgeLength, wishes.at(p));
  };
  const double finest = std::min(graded ? settings.smallest : settings.edgeLength, wishes.least());
  int levels = 0;
  for (double length = settings.edgeLength; length > 1.5 * finest; length *= 0.5)
    ++levels;

  const double steps = settings.iterations * (1.0 + levels);
  double step = 0.0;
  const auto next = [&] { watch.setShare(0.05 + 0.9 * ++step / steps); };
  for (int i = 0; i < settings.iterations; ++i)
  {
    remesher.iterate(remesher.faces(), settings.edgeLength);
    next();
  }
  double length = settings.edgeLength;
  for (int level = 0; level < levels; ++level)
  {
    length *= 0.5;
    for (int i = 0; i < settings.iterations; ++i)
    {
      remesher.iterateWhere(wanted, 1.5 * length, length);
      next();
    }
  }

  mesh = remesher.result();
  result.trianglesAfter = mesh.triangles.size();
  result.pointsAfter = mesh.points.size();
  result.areaAfter = area(mesh);
  measureQuality(mesh, settings.edgeLength, result);
  report(progress, 1.0);
  return result;
}
}  // namespace kalos::meshing
