// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie in one place: a carpet on a floor, walls back to back, a panel in a ceiling, a decal.
#ifndef kalos_scene_CoplanarFaces_h
#define kalos_scene_CoplanarFaces_h

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/Vector.h"

namespace kalos
{
class Scene;

/// Faces of two materials that lie in one place, over `area` in all. The rule, which every ray obeys: a face is seen
/// from its own side before what shows its back there; of two that show the same side, a luminous face lies on top of
/// one that is not, and else the later in the scene does. So each side of a wall of two faces back to back keeps its
/// own.
struct Overlap
{
  std::uint32_t above = 0, below = 0;  ///< a triangle of each; back to back: the later and the earlier
  bool backToBack = false;             ///< their normals are opposite: either is seen from its own side
  double area = 0;                     ///< m2
  Vec3 middle;                         ///< of the largest piece
};

struct CoplanarFaces
{
  std::vector<Overlap> overlaps;  ///< by surfaces and materials, the largest first
  std::vector<char> marks;        ///< 1: the triangle lies in one place with another, in part at least; or empty
  std::map<std::uint32_t, std::vector<std::array<Vec3, 3>>>
      luminousParts;  ///< of luminous triangles under others: what is left
};

/// Finds the triangles that lie in one place with others of another material, or are luminous as these are. In one
/// place: parallel, and no farther apart than single precision can tell (Scene::reach()). Dark triangles of one
/// material are alike whichever of them is met.
///
/// Time: n log n for n triangles.
CoplanarFaces findCoplanarFaces(const Scene& scene);

/// Of two such triangles, whether a ray along `direction` sees a instead of b.
bool liesOver(const Scene& scene, std::uint32_t a, std::uint32_t b, const Vec3& direction);
}  // namespace kalos

#endif
