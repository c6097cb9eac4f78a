// SPDX-License-Identifier: BSD-3-Clause
// What RayScene keeps: Embree's scene, and single rays decided in double precision.
#ifndef kalos_scene_EmbreeScene_h
#define kalos_scene_EmbreeScene_h

#include "scene/EmbreeApi.h"
#include "scene/RayScene.h"

namespace kalos
{
/// The triangles in Embree, and in double precision for decisions that single precision cannot take.
struct EmbreeScene
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Vec3> points;  // in double precision, for tests that single precision cannot decide
  std::vector<Triangle> triangles;
  double extent = 0;  // m, largest coordinate

  EmbreeScene() = default;
  ~EmbreeScene();

  /// Throws std::runtime_error when there is not enough memory.
  void build(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

  // Candidates in single precision, from a little behind the start to a little beyond the end; the filter keeps those
  // between them. Triangles near a crowded end are met in double precision instead, and are no candidates.
  struct Query
  {
    embree::QueryContext context;  // first: the filter finds the query at its address
    const EmbreeScene* scene;
    RayAnchor start;
    Vec3 direction;
    const RayAnchor* end;  // null: the ray goes on for ever
    std::vector<std::uint32_t> near;
  };

  Query ask(const RayAnchor& start, const Vec3& direction, const RayAnchor* end, RTCRay& ray) const;
  void addNear(const RayAnchor& anchor, std::vector<std::uint32_t>& near) const;
  bool isBetween(const Query& query, std::uint32_t triangle) const;
  Hit meet(const Query& query, std::uint32_t triangle, double& distance) const;
  Hit firstNear(const Query& query, double& distance) const;
  double distanceTo(const Query& query, std::uint32_t triangle) const;
  Hit first(const RayAnchor& start, const Vec3& direction) const;
  static void keepAhead(const RTCFilterFunctionNArguments* filter);
  static void search(RTCScene scene, const Vec3& p, double radius, const std::function<bool(std::uint32_t)>& visit);
};

/// A ray from `origin` that ends `far` lengths of its direction away.
RTCRay makeRay(const Vec3& origin, const Vec3& direction, float far);
}  // namespace kalos

#endif
