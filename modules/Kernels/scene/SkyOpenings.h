// SPDX-License-Identifier: BSD-3-Clause
// Also known as: portals. Where light of the sky enters, found from rays that escape from the receivers.
#ifndef kalos_scene_SkyOpenings_h
#define kalos_scene_SkyOpenings_h

#include <array>
#include <string>
#include <vector>

#include "sampling/SampleStream.h"
#include "scene/RectangleCover.h"
#include "scene/Scene.h"

namespace kalos
{
/// Rectangles on the faces of a box about the receivers. They say where to sample; no estimate relies on their being
/// complete: what enters beside them is found by other samples, with more noise.
class SkyOpenings
{
public:
  /// None are known.
  SkyOpenings() = default;

  /// From paths that start at the receivers, given as anchors, and are reflected diffusely until they escape. The box
  /// has the orientation of the scene's largest surfaces, and its faces lie where the rays pass through the least area:
  /// at a window rather than far outside.
  SkyOpenings(const Scene& scene, const std::vector<RayAnchor>& receivers, const Walks& walks);

  struct Rectangle
  {
    int face;  // of the box
    Vec3 corner, u, v;
    Vec3 outward;  // unit normal
    double area;   // m2
    double rays;   // share of the rays that escape from inside the box
  };
  const std::vector<Rectangle>& all() const { return this->Rectangles; }
  bool any() const { return !this->Rectangles.empty(); }

  /// Rays that were followed until they were absorbed or had escaped, and those that had escaped.
  std::size_t followed() const { return this->Followed; }
  std::size_t escaped() const { return this->Escaped; }
  /// Whether most of what the receivers see is sky: openings are no help then, and none are looked for.
  bool isOutdoors() const { return 2 * this->AtOnce > this->Followed; }

  /// Whether a point lies within the box.
  bool encloses(const Vec3& p) const;

  /// Where the straight line through p along `direction` leaves the box, and through which face; -1 when it misses it.
  int exit(const Vec3& p, const Vec3& direction, Vec3& point) const;

  /// Whether a point of that face lies in rectangle i.
  bool covers(std::size_t i, int face, const Vec3& point) const;

private:
  struct Ray
  {
    Vec3 from, direction;
  };
  struct Face
  {
    int face;
    double u, v;
  };
  using Box = std::array<std::array<double, 2>, 3>;  // along each axis, low and high

  void orient(const Scene& scene);
  std::vector<Ray> escapes(const Scene& scene, const std::vector<RayAnchor>& receivers, const Walks& walks);
  void place(const Scene& scene, const std::vector<RayAnchor>& receivers, const std::vector<Ray>& rays);
  void placeFace(int face, const Box& inner, const std::vector<double>& places, double gap,
                 const std::vector<Ray>& rays);
  double cost(const Box& box, const std::vector<Ray>& rays, std::size_t step) const;
  bool exitOf(const Box& box, const Vec3& p, const Vec3& d, Face& found) const;  // both in the box's axes
  Vec3 local(const Vec3& v) const { return {dot(v, this->Axes[0]), dot(v, this->Axes[1]), dot(v, this->Axes[2])}; }
  void keep(const std::vector<Ray>& rays);
  void add(int face, const CoverRectangle& r, double share);

  Vec3 Axes[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Box Bounds{};
  std::vector<Rectangle> Rectangles;
  std::vector<std::array<double, 4>>
      Extents;  // of each rectangle on its face: lowest and highest u, lowest and highest v
  std::size_t Followed = 0, Escaped = 0, AtOnce = 0;  // of the rays, AtOnce with their first segment
};
}  // namespace kalos

#endif
