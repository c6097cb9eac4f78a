// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Placement.h"

namespace kalos
{
namespace
{
// A triangle that the receiver touches: its plane, and on which side of it the receiver's own surface extends.
struct Touched
{
  std::uint32_t triangle;
  Vec3 corner, normal;
  double reaches = 0;  // m, error of the plane in single precision

  double height(const Vec3& p) const { return dot(p - this->corner, this->normal); }
};

// The rounding error of p along n: of single precision for the smaller of its scene and world coordinates, plus double
// precision for its world coordinates.
double inputRounding(const Scene& scene, const Vec3& p, const Vec3& n)
{
  const Vec3 world = p + scene.origin();
  const Vec3 smaller{std::min(std::abs(p.x), std::abs(world.x)), std::min(std::abs(p.y), std::abs(world.y)),
                     std::min(std::abs(p.z), std::abs(world.z))};
  return 0x1.0p-23 * absDot(n, smaller) + 0x1.0p-50 * absDot(n, world);
}

class Surroundings
{
public:
  Surroundings(const Scene& scene, const Vec3& p, const Vec3& n) : Lit(scene), Near(scene.contact(p))
  {
    std::vector<std::uint32_t> found;
    scene.rays().nearby(p, 2 * this->Near, [&](std::uint32_t t) {
      found.push_back(t);
      return true;
    });
    std::sort(found.begin(), found.end());  // sorted, because the search returns no fixed order
    for (const std::uint32_t t : found)
    {
      const RayAnchor anchor = scene.anchor(t, p, scene.normal(t));
      const Touched touched{t, scene.corner(t, 0), scene.normal(t), anchor.liftFor(p)};
      const double reach = std::max(this->Near, touched.reaches);
      if (std::abs(touched.height(p)) > reach || !scene.isOver(t, p, reach))
        continue;
      (std::abs(dot(touched.normal, n)) > 0.999 ? this->Own : this->Others).push_back(touched);
    }
  }

  /// +1 or -1: the side of the triangle that the receiver belongs to if it lies in its plane.
  double side(const Touched& other) const
  {
    double low = 0, high = 0;
    for (const Touched& own : this->Own)
      for (int i = 0; i < 3; ++i)
      {
        const double height = other.height(this->Lit.corner(own.triangle, i));
        low = std::min(low, height);
        high = std::max(high, height);
      }
    return low < -this->Near && !(high > this->Near) ? -1 : 1;
  }

  /// Moves p off the planes in which it lies but for rounding.
  Vec3 settle(Vec3 p) const
  {
    for (const Touched& other : this->Others)
    {
      const double rounding = inputRounding(this->Lit, p, other.normal), height = other.height(p);
      const double side = this->side(other);
      if (std::abs(height) <= rounding && side * height <= 0x1.0p-4 * rounding)
        p += (side * this->room(other, p, side) - height) * other.normal;
    }
    return p;
  }

  /// Whether single precision may put a receiver at p, or where it is lifted to, on the other side of a surface.
  bool crowds(const Vec3& p, const Vec3& lifted) const
  {
    return std::any_of(this->Others.begin(), this->Others.end(), [&](const Touched& other) {
      const double height = other.height(p);
      return std::abs(height) < other.reaches || height * other.height(lifted) < 0;
    });
  }

private:
  // How far the receiver moves away from `from`: enough for single precision, but less than half the way to the next
  // surface.
  double room(const Touched& from, const Vec3& p, double side) const
  {
    double room = 1.5 * from.reaches;
    for (const Touched& other : this->Others)
    {
      const double height = other.height(p), change = side * dot(from.normal, other.normal);
      if (std::abs(height) > inputRounding(this->Lit, p, other.normal) && change * height < 0)
        room = std::min(room, 0.5 * std::abs(height / change));
    }
    return room;
  }

  const Scene& Lit;
  double Near;
  std::vector<Touched> Own, Others;  // parallel to the receiver, and across it
};
}  // namespace

RayAnchor placeReceiver(const Scene& scene, const Vec3& p, const Vec3& n)
{
  const Surroundings surroundings(scene, p, n);
  RayAnchor anchor = scene.anchor(surroundings.settle(p), n);
  anchor.crowded = surroundings.crowds(anchor.point, anchor.lifted());
  return anchor;
}
}  // namespace kalos
