// SPDX-License-Identifier: BSD-3-Clause
// The largest plane glossy surfaces of a scene: where the highlights of luminaires can be found by their mirror images.
#ifndef kalos_scene_GlossyPlanes_h
#define kalos_scene_GlossyPlanes_h

#include <cstdint>
#include <vector>

#include "geometry/Vector.h"
#include "material/Brdf.h"

namespace kalos
{
class Scene;

/// Triangles of one glossy material in one plane.
struct GlossyPlane
{
  Vec3 point;
  Frame axes;                 ///< its third axis is the normal
  const Brdf* brdf;           ///< of the material
  double low[2], high[2];     ///< m, bounds of the triangles along the first two axes, from `point`
  double reflectingArea = 0;  ///< m2, times the specular reflectance
};

class GlossyPlanes
{
public:
  /// More planes would cost each sample more than they spare: the `most` that reflect most are kept.
  static constexpr std::size_t most = 16;

  explicit GlossyPlanes(const Scene& scene);

  const std::vector<GlossyPlane>& planes() const { return this->Planes; }
  bool any() const { return !this->Planes.empty(); }

  static constexpr std::uint8_t none = 255;
  /// Index of the plane that a triangle belongs to, or `none`.
  std::uint8_t of(std::uint32_t triangle) const { return this->any() ? this->OfTriangle[triangle] : none; }

private:
  std::vector<GlossyPlane> Planes;
  std::vector<std::uint8_t> OfTriangle;  // empty without planes
};
}  // namespace kalos

#endif
