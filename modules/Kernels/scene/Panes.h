// SPDX-License-Identifier: BSD-3-Clause
// The panes of glass of a scene: what they take away between two points, and where a ray meets one.
#ifndef kalos_scene_Panes_h
#define kalos_scene_Panes_h

#include <memory>
#include <vector>

#include "material/Glass.h"
#include "scene/RayScene.h"

namespace kalos
{
class Panes
{
public:
  /// `glass`: one per triangle, null where it is none.
  Panes(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
        std::vector<std::shared_ptr<const Glass>> glass);

  /// Share of the light that passes straight between two points which nothing opaque separates.
  double transmittance(const RayAnchor& a, const RayAnchor& b) const;

  /// Whether a pane lies between two points.
  bool anyBetween(const RayAnchor& a, const RayAnchor& b) const { return this->Rays.occluded(a, b); }

  /// First pane along a ray.
  Hit first(const RayAnchor& start, const Vec3& direction) const { return this->Rays.intersect(start, direction); }

  bool reflects() const;  ///< whether one of them does

  const Glass& glass(std::uint32_t triangle) const { return *this->Of[triangle]; }

private:
  std::vector<std::shared_ptr<const Glass>> Of;
  std::vector<Vec3> Normals;  // of the panes
  RayScene Rays;
};

/// The triangles, but only the panes among them or only the others: what is left out is collapsed to a point, which no
/// ray meets.
std::vector<Triangle> collapsed(const std::vector<Triangle>& triangles,
                                const std::vector<std::shared_ptr<const Glass>>& glass, bool panesOnly);
}  // namespace kalos

#endif
