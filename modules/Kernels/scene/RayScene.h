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
  double distance = 0;  ///< in lengths of the ray's direction
};

/// Sixteen segments in structure-of-arrays form: from o to o + d.
struct alignas(64) SegmentPacket
{
  static constexpr int width = 16;
  float ox[width], oy[width], oz[width], dx[width], dy[width], dz[width];
};

class RayScene
{
public:
  enum class Queries
  {
    FirstHit,     ///< intersect() and occluded()
    AllCrossings  ///< crossings() too
  };

  /// Copies the triangles; points in metres, near the origin (single precision inside).
  RayScene(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
           Queries queries = Queries::FirstHit);
  ~RayScene();

  /// First hit of the ray from `origin`, which the caller has moved off its surface, along `direction`.
  Hit intersect(const Vec3& origin, const Vec3& direction) const;

  /// True when anything lies between the points a and b, which the caller has moved off their surfaces.
  bool occluded(const Vec3& a, const Vec3& b) const;

  /// Bit i of the result is set when segment i (of the first `count`) is occluded.
  std::uint32_t occluded(const SegmentPacket& segments, int count) const;

  /// With Queries::AllCrossings: calls `visit(triangle)` for every triangle crossed by the segment from a to b, in no
  /// particular order.
  void crossings(const Vec3& a, const Vec3& b, const std::function<void(std::uint32_t)>& visit) const;

  /// Calls `visit(triangle)` for every triangle whose bounding box comes within `radius` of p, possibly for some more;
  /// no longer than a little after it returned false.
  void nearby(const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit) const;

private:
  struct Embree;
  std::unique_ptr<Embree> Impl;
};
}  // namespace kalos

#endif
