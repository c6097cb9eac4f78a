// SPDX-License-Identifier: BSD-3-Clause
// The scene as the estimators use it, in coordinates about its centre.
#ifndef kalos_scene_Scene_h
#define kalos_scene_Scene_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/Vector.h"
#include "luminaire/Luminaire.h"
#include "material/Brdf.h"
#include "scene/CoplanarFaces.h"
#include "scene/GlossyPlanes.h"
#include "scene/RayScene.h"

namespace kalos
{
/// Input: triangles with a material each, and luminaires, in metres anywhere in space.
struct SceneDescription
{
  int bands = 1;  ///< 1..maxBands
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> triangleMaterial;  ///< index into materials, one per triangle
  std::vector<Material> materials;
  std::vector<Luminaire> luminaires;
  std::vector<std::uint32_t> triangleSurface;  ///< index into surfaceNames, one per triangle; or empty
  std::vector<std::string> surfaceNames;       ///< for messages; or empty: materials stand for surfaces
  std::vector<std::string> luminaireNames;     ///< for messages; or empty: numbers stand for them
};

/// A point of a surface, found by a ray.
struct SurfacePoint
{
  bool valid = false;
  std::uint32_t triangle = 0;
  Vec3 position;
  Vec3 normal;        ///< unit, on the side the ray came from
  bool front = true;  ///< that side is the side of the triangle's own normal
};

class Scene
{
public:
  /// Moves the origin to the centre of the bounding box: rays in single precision then work even for a hall 1 km away.
  /// Throws std::invalid_argument on inconsistent sizes, non-finite numbers and degenerate triangles.
  explicit Scene(SceneDescription description);

  int bands() const { return this->Data.bands; }
  const SceneDescription& data() const { return this->Data; }
  const RayScene& rays() const { return this->Rays; }
  const Vec3& origin() const { return this->Origin; }  ///< subtract from a world point to get a scene point
  double size() const { return this->Size; }           ///< largest side of the bounding box, m
  double surfaceArea() const { return this->SurfaceArea; }

  const Material& material(std::uint32_t triangle) const
  {
    return this->Data.materials[this->Data.triangleMaterial[triangle]];
  }
  /// The lobe and the mirror share of a triangle's material, without its diffuse part.
  const Brdf& lobe(std::uint32_t triangle) const { return this->Lobes[this->Data.triangleMaterial[triangle]]; }
  const Brdf& brdf(std::uint32_t triangle) const { return this->Brdfs[this->Data.triangleMaterial[triangle]]; }

  /// Surfaces as messages name them, and the one that a triangle belongs to.
  std::size_t surfaces() const
  {
    return this->Data.surfaceNames.empty() ? this->Data.materials.size() : this->Data.surfaceNames.size();
  }
  std::size_t surface(std::uint32_t triangle) const
  {
    return this->Data.surfaceNames.empty() ? this->Data.triangleMaterial[triangle]
                                           : this->Data.triangleSurface[triangle];
  }
  std::string surfaceName(std::size_t surface) const
  {
    return this->Data.surfaceNames.empty() ? "what is of material " + std::to_string(surface)
                                           : "surface " + this->Data.surfaceNames[surface];
  }

  const Vec3& normal(std::uint32_t triangle) const { return this->Normals[triangle]; }
  double area(std::uint32_t triangle) const { return this->Areas[triangle]; }
  Vec3 corner(std::uint32_t triangle, int i) const { return this->Data.points[this->Data.triangles[triangle][i]]; }

  /// Faces that lie in one place, and whether a triangle does with another, in part at least.
  const std::vector<Overlap>& overlaps() const { return this->Coplanar.overlaps; }
  bool isOverlapped(std::uint32_t triangle) const
  {
    return !this->Coplanar.marks.empty() && this->Coplanar.marks[triangle];
  }

  /// The triangle that a ray along `direction` sees at a point p of triangle t, which may be overlapped there.
  std::uint32_t uppermost(std::uint32_t t, const Vec3& p, const Vec3& direction) const;

  /// The parts of a luminous triangle that shine: all of it, but for those that lie under others.
  std::vector<std::array<Vec3, 3>> luminousParts(std::uint32_t triangle) const;

  /// First surface point along a ray from a start (see anchor()), or from a point in free space.
  SurfacePoint trace(const RayAnchor& start, const Vec3& direction) const;

  /// The surface point that a ray along `direction` has hit.
  SurfacePoint point(const Hit& hit, const Vec3& direction) const;

  /// Where rays leave or reach a point p of a triangle, n being its normal or the opposite.
  ///
  /// Lift: in single precision a triangle's plane is missed by up to ten roundings (2^-24 each) of the
  /// coordinates of corners, ray ends and the way between, as they add up along n: |n_x| x + |n_y| y + |n_z| z. A plane
  /// across an axis has one coordinate only, and is exact in the others. The plane of a slender triangle tilts with its
  /// corners' rounding: by more, the longer it is over its height.
  RayAnchor anchor(std::uint32_t triangle, const Vec3& p, const Vec3& n) const
  {
    const Lift& lift = this->Lifts[triangle];
    return {p, n, lift.base, lift.slope};
  }
  RayAnchor anchor(const SurfacePoint& p) const { return this->anchor(p.triangle, p.position, p.normal); }

  /// The same of a point that may lie on a surface of normal n, or on none.
  RayAnchor anchor(const Vec3& p, const Vec3& n) const { return this->anchorWithin(p, n, this->contact(p)); }

  /// Where rays from and to the point in the middle of luminaire i start and end: a lamp mounted flush with a ceiling
  /// shines into the room.
  const RayAnchor& luminaireAnchor(std::size_t i) const { return this->LuminaireAnchors[i]; }

  const GlossyPlanes& glossyPlanes() const { return *this->Glossy; }

  /// How far, m, single precision may put a ray from or to p on a triangle off its plane.
  double reach(std::uint32_t triangle, const Vec3& p) const
  {
    const Lift& lift = this->Lifts[triangle];
    return lift.base + lift.slope * absDot(this->Normals[triangle], p);
  }

  /// Distance, m, below which a point may be meant to lie on a surface.
  double contact(const Vec3& p) const { return roundingScale * (maxAbs(p) + 0.05 * this->Size); }

  /// Whether p, near the plane of a triangle, lies over it or within `reach` (m) of its border.
  bool isOver(std::uint32_t triangle, const Vec3& p, double reach) const;

  /// Whether every surface on the side of the unit normal n of the sensor at p is `radius` away, or has nowhere a
  /// larger kernel with it than a wall at right angles which is: pi G <= sqrt(27)/16 / radius^2. So a wall that leans
  /// away is clear at less. Conservative: it may be false where a surface that reaches to that side is so near on
  /// the other, or where thousands of triangles are so near.
  bool clear(const Vec3& p, const Vec3& n, double radius) const;

private:
  static constexpr double roundingScale = 0x1.4p-21;

  // An anchor at p lifted off all surfaces of normal n that come within `radius` of p, and by contact(p) at least.
  RayAnchor anchorWithin(const Vec3& p, const Vec3& n, double radius) const;
  // Lift of rays at a triangle: m for its own coordinates, and per metre of the ends' coordinates.
  struct Lift
  {
    float base, slope;
  };
  Lift liftAt(std::uint32_t triangle) const;

  static Vec3 recentre(SceneDescription& description, double& size);

  SceneDescription Data;
  double Size = 0;
  Vec3 Origin;
  RayScene Rays;
  std::vector<Brdf> Brdfs, Lobes;  // one per material
  std::vector<Vec3> Normals;
  std::vector<double> Areas;
  std::vector<Lift> Lifts;
  double SurfaceArea = 0;
  std::vector<RayAnchor> LuminaireAnchors;
  CoplanarFaces Coplanar;
  std::shared_ptr<const GlossyPlanes> Glossy;
};
}  // namespace kalos

#endif
