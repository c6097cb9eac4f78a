// SPDX-License-Identifier: BSD-3-Clause
// Rays against triangles. The only interface of Kalos to a ray tracing library.
#ifndef kalos_scene_RayScene_h
#define kalos_scene_RayScene_h

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "scene/RayPackets.h"

namespace kalos
{
struct EmbreeScene;

using Triangle = std::array<std::uint32_t, 3>;

struct Hit
{
  bool valid = false;
  std::uint32_t triangle = 0;
  double u = 0, v = 0;  ///< barycentric weights of the triangle's second and third corner
};

class Panes;

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

  /// Panes of glass that stand among the triangles; rays pass through them, see scene/Panes.h.
  void setPanes(std::shared_ptr<const Panes> panes) { this->Glass = std::move(panes); }
  const Panes* panes() const { return this->Glass.get(); }

  /// What the panes between two points let through, where occluded() is false; 1 without panes.
  double transmittance(const RayAnchor& a, const RayAnchor& b) const;

private:
  std::unique_ptr<EmbreeScene> Impl;
  std::shared_ptr<const Panes> Glass;
};
}  // namespace kalos

#endif
