// SPDX-License-Identifier: BSD-3-Clause
// Rays against triangles. The only interface of Kalos to a ray tracing library.
#ifndef kalos_scene_RayScene_h
#define kalos_scene_RayScene_h

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
using Triangle = std::array<std::uint32_t, 3>;

struct Hit
{
  bool valid = false;
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< barycentric weights of the triangle's second and third corner
};

/// Where a ray starts or ends: at a point in free space, or at a point of a surface, whose own triangle it must not
/// meet. A single ray decides in double precision which triangles lie between its ends, so that it leaves a gap of any
/// width; but to triangles nearly parallel to the surface it reaches to lifted() only: models hold layers that nearly
/// coincide. Rays in packets are in single precision: both ends are lifted by the error of single precision, which
/// depends on the coordinates of the surface and of *both* ends, see Scene::anchor().
struct RayAnchor
{
  Vec3 point;
  Vec3 normal;       ///< unit, off the surface; zero in free space
  double base = 0;   ///< m, lift for the coordinates of the surface
  double slope = 0;  ///< lift for each metre of the ends' coordinates along the normal
  /// Other surfaces are so near that single precision cannot tell on which side of them the anchor lies: single rays
  /// test these in double precision; packets must not be used.
  bool crowded = false;

  RayAnchor() = default;
  RayAnchor(const Vec3& p) : point(p) {}  // implicit: most ends are points in free space
  RayAnchor(const Vec3& p, const Vec3& n, double liftOfSurface, double liftPerMetre)
      : point(p), normal(n), base(liftOfSurface), slope(liftPerMetre)
  {
  }

  /// m, how far the end of a ray is lifted whose other end is q.
  double liftFor(const Vec3& q) const { return this->base + this->slope * absDot(this->normal, q); }
  Vec3 liftedFor(const Vec3& q) const { return this->point + this->liftFor(q) * this->normal; }

  /// The same for a ray that starts here and ends anywhere.
  double lift() const { return this->liftFor(this->point); }
  Vec3 lifted() const { return this->liftedFor(this->point); }
};

/// Sixteen segments in structure-of-arrays form: from o to o + d.
struct alignas(64) SegmentPacket
{
  static constexpr int width = 16;
  float ox[width], oy[width], oz[width], dx[width], dy[width], dz[width];

  void set(int i, const Vec3& o, const Vec3& d)
  {
    this->ox[i] = static_cast<float>(o.x);
    this->oy[i] = static_cast<float>(o.y);
    this->oz[i] = static_cast<float>(o.z);
    this->dx[i] = static_cast<float>(d.x);
    this->dy[i] = static_cast<float>(d.y);
    this->dz[i] = static_cast<float>(d.z);
  }

  /// Between two anchors, both lifted.
  void set(int i, const RayAnchor& from, const RayAnchor& to)
  {
    const Vec3 o = from.liftedFor(to.point);
    this->set(i, o, to.liftedFor(from.point) - o);
  }

  void copy(int i, const SegmentPacket& from, int k)
  {
    this->ox[i] = from.ox[k];
    this->oy[i] = from.oy[k];
    this->oz[i] = from.oz[k];
    this->dx[i] = from.dx[k];
    this->dy[i] = from.dy[k];
    this->dz[i] = from.dz[k];
  }
};

/// Sixteen anchors, in the same form and precision.
struct alignas(64) AnchorPacket
{
  static constexpr int width = SegmentPacket::width;
  float px[width], py[width], pz[width], nx[width], ny[width], nz[width], base[width], slope[width];

  void set(int i, const RayAnchor& a)
  {
    this->px[i] = static_cast<float>(a.point.x);
    this->py[i] = static_cast<float>(a.point.y);
    this->pz[i] = static_cast<float>(a.point.z);
    this->nx[i] = static_cast<float>(a.normal.x);
    this->ny[i] = static_cast<float>(a.normal.y);
    this->nz[i] = static_cast<float>(a.normal.z);
    this->base[i] = static_cast<float>(a.base);
    this->slope[i] = static_cast<float>(a.slope);
  }
};

/// The segments from one anchor to sixteen, as SegmentPacket::set() makes them, in single precision.
void connect(const RayAnchor& from, const AnchorPacket& to, SegmentPacket& segments);

/// Where sixteen rays end. Of ray i: `triangle` is noTriangle when it ends nowhere, `distance` is in lengths of its
/// direction, u and v are as in Hit.
struct alignas(64) HitPacket
{
  static constexpr std::uint32_t noTriangle = ~0u;
  std::uint32_t triangle[SegmentPacket::width];
  float distance[SegmentPacket::width], u[SegmentPacket::width], v[SegmentPacket::width];
};

class RayScene
{
public:
  static constexpr double crowd = 16;  ///< lifts: from a crowded anchor, triangles within are met in double precision

  /// Copies the triangles; points in metres, near the origin (single precision inside).
  RayScene(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  ~RayScene();

  /// First hit of a ray along `direction`.
  Hit intersect(const RayAnchor& start, const Vec3& direction) const;

  /// First hits of the first `count` rays from o along d. All in single precision: the caller has moved the starts off
  /// their surfaces.
  void intersect(const SegmentPacket& rays, int count, HitPacket& hits) const;

  /// True when anything lies between a and b.
  bool occluded(const RayAnchor& a, const RayAnchor& b) const;

  /// Bit i of the result is set when segment i (of the first `count`) is occluded. All in single precision: the caller
  /// has moved both ends off their surfaces.
  std::uint32_t occluded(const SegmentPacket& segments, int count) const;

  /// Calls `visit(triangle)` for every triangle crossed by the segment from a to b, in no particular order; in single
  /// precision.
  void crossings(const Vec3& a, const Vec3& b, const std::function<void(std::uint32_t)>& visit) const;

  /// Calls `visit(triangle)` for every triangle whose bounding box comes within `radius` of p, possibly for some more.
  /// It may be called a few more times after it returned false.
  void nearby(const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit) const;

private:
  struct Embree;
  std::unique_ptr<Embree> Impl;
};
}  // namespace kalos

#endif
