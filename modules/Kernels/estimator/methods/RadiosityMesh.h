// SPDX-License-Identifier: BSD-3-Clause
// The elements of finite-element radiosity: the sides of a scene's triangles that light can reach, cut into congruent
// triangles no longer than a given length.
#ifndef kalos_estimator_methods_RadiosityMesh_h
#define kalos_estimator_methods_RadiosityMesh_h

#include "estimator/tracing/Emission.h"
#include "scene/Scene.h"

namespace kalos
{
struct RadiosityElement
{
  Vec3 corner[3];
  Vec3 normal;  ///< unit, on the side that reflects
  std::uint32_t triangle;
  bool front;  ///< that side is the side of the triangle's own normal
};

/// The sides of triangles that light can reach: those that some trajectories meet, and what is seen from these, by
/// 64 rays from each. A side that no ray meets takes no part.
class LitSides
{
public:
  LitSides(const Scene& scene, const Emission& emission, std::uint64_t seed);

  bool lit(std::uint32_t triangle, bool front) const { return this->Lit[2 * triangle + front] != 0; }
  std::size_t count() const { return this->Sides; }

private:
  std::vector<char> Lit;
  std::size_t Sides = 0;
};

class RadiosityMesh
{
public:
  /// Elements with no edge longer than `length`, m.
  RadiosityMesh(const Scene& scene, const LitSides& sides, double length);

  const std::vector<RadiosityElement>& elements() const { return this->Elements; }

  /// Number of elements of that length.
  static std::size_t count(const Scene& scene, const LitSides& sides, double length);

  /// The length at which there are about `wanted` elements, at least one a side.
  static double lengthFor(const Scene& scene, const LitSides& sides, std::size_t wanted);

  /// The element about a surface point and the weights of its corners there; false where no light comes.
  struct Place
  {
    std::size_t element;
    double weight[3];
  };
  bool locate(const SurfacePoint& point, Place& place) const;

private:
  static std::uint32_t cuts(const Scene& scene, std::uint32_t triangle, double length);  // of an edge into so many

  const Scene& Scene_;
  std::vector<RadiosityElement> Elements;
  std::vector<std::size_t> First;   // element of each side; noElement: not lit
  std::vector<std::uint32_t> Cuts;  // per triangle
};
}  // namespace kalos

#endif
